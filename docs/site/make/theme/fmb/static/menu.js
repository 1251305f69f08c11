/* On a narrow screen the button shows and hides the list of pages. */
const menu = document.getElementById("menu");
document.documentElement.classList.add("scripted");
menu.addEventListener("click", () => {
    const shown = document.getElementById("pages").classList.toggle("shown");
    menu.setAttribute("aria-expanded", shown);
});
