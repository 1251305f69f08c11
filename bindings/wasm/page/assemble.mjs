// One file of page, style, program and engine. usage: node assemble.mjs INDEX STYLE PAGE ENGINE OUT
import { readFileSync, writeFileSync } from "node:fs";

const [index, style, page, engine, out] = process.argv.slice(2);
const text = (path) => readFileSync(path, "utf8");

// In a page, any text that looks like the end of a script ends it.
const script = (path) => text(path).replaceAll("</script", "<\\/script");
const parts = { STYLE: text(style), PAGE: script(page), ENGINE: script(engine) };
writeFileSync(out, text(index).replace(/@(STYLE|PAGE|ENGINE)@/g, (_, name) => parts[name]));
