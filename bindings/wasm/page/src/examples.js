// Systems behind links: #example=breakfast.

export const EXAMPLES = {
  triangle: { title: "A first one", text: "# Drag a line of the picture, or change a number here.\nx + y <= 6\ny <= 2x + 1\nx - 3y <= 2\nmax: x + 2y\n" },
  breakfast: {
    title: "Breakfast for 1.20 euro",
    text: `# How much bread, milk and egg [portions] makes a breakfast for 1.20 euro?
vars: bread milk egg
energy:  250 bread + 150 milk + 90 egg >= 600    # [kcal]
protein: 8 bread + 8 milk + 7 egg >= 22          # [g]
calcium: 30 bread + 300 milk + 25 egg >= 300     # [mg]
price:   0.4 bread + 0.35 milk + 0.3 egg <= 1.2  # [euro]
0 <= bread <= 3
0 <= milk < 2.5
0 <= egg <= 2
`,
  },
  schedule: {
    title: "A room between 8 and 12",
    text: `# A room is painted, dries, gets its carpet and its furniture: can it be done between 8 and 12?
opening:   paint >= 8
drying:    carpet >= paint + 2.5
glue:      furniture >= carpet + 1
closing:   furniture + 1 <= 12
lunch:     lunch >= 11
appetite:  lunch <= 13
`,
  },
  cube: {
    title: "A cube without a corner",
    text: "0 <= x <= 1\n0 <= y <= 1\n0 <= z <= 1\ncut: x + y + z <= 2.4\n",
  },
  open: { title: "Strict rows", text: "# Every bound is there, none is reached.\n0 < x < 1\nx < y < 2x + 1\n" },
  kohler: {
    title: "A conflict of five rows",
    text: "x - y <= -1\n-x + 2y + 2z <= -1\nx + y - 2z <= 1\nx - 2y <= -2\n-2x + y <= 1\n",
  },
  shadow: {
    title: "The shadow of a cube",
    text: `# A cube in four dimensions throws a shadow on the plane: how many corners has it?
vars: x y a b c d
x = 4a + 3b + c
y = b + 3c + 4d
-1 <= a <= 1
-1 <= b <= 1
-1 <= c <= 1
-1 <= d <= 1
`,
  },
};
