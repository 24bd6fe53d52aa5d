// SPDX-License-Identifier: MIT
//
// Makes a small page and uses it as people do, in a headless browser: chooses a snippet and a dialect, copies, looks.
//
//     node check.mjs GALLERY VIEWER ORIGINALS CHROMIUM NODE_MODULES WORK_FOLDER GLSLANG
//
// Ends with 77, skipped, where there is no browser or no playwright-core.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [gallery, viewer, originals, chromium, modules, work, glslang] = process.argv.slice(2);
const skip = why => {
  console.log("SKIPPED: " + why);
  process.exit(77);
};
if (!existsSync(chromium)) skip("no chromium (Debian: chromium)");
if (!existsSync(join(modules, "playwright-core"))) skip("no playwright-core in " + modules + ": make test-all installs it");
const playwright = createRequire(import.meta.url)(join(modules, "playwright-core"));

// The page, and the same from the original programs.
rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
const size = 150, file = join(work, "index.html");
execFileSync(gallery, ["--output", file, "--size", String(size), "--viewer", viewer], { stdio: "inherit" });

const profile = mkdtempSync(join(work, "profile-"));
const context = await playwright.chromium.launchPersistentContext(profile, {
  executablePath: chromium, headless: true, viewport: { width: 1200, height: 900 },
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"],
});
let problems = 0;
try {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const page = await context.newPage();
  const said = [], requests = [];
  page.on("console", message => said.push(message.text()));
  page.on("pageerror", error => said.push(String(error)));
  page.on("request", request => requests.push(request.url().slice(0, 60)));
  await page.goto(pathToFileURL(file).href);

  const check = (name, works) => {
    try {
      works();
      console.log("passed  " + name);
    } catch (error) {
      ++problems;
      console.log("FAILED  " + name + "\n" + error.message);
    }
  };

  // Copying, by the clipboard of today and by the one of old.
  const box = page.locator("#pcf_2x2 .code"), text = () => box.locator("pre").textContent();
  const copies = async (name, dialect, first) => {
    await box.locator(".dialect").selectOption(dialect);
    const shown = await text();
    await page.evaluate(() => navigator.clipboard.writeText("something else").catch(() => {}));
    await box.locator("button").click();
    await page.waitForFunction(() => document.querySelector("#pcf_2x2 button").textContent === "Copied");
    const copied = await page.evaluate(() => real_clipboard.readText());
    check(name, () => {
      assert.ok(shown.startsWith(first), shown.slice(0, 40));
      assert.match(shown, /float umbrage_pcf_2x2\(/);
      assert.equal(copied, shown);
    });
    await page.waitForFunction(() => document.querySelector("#pcf_2x2 button").textContent === "Copy");
  };
  await page.evaluate(() => globalThis.real_clipboard = navigator.clipboard);
  await copies("a dialect is chosen and copied", "100", "#version 100\n");
  await copies("another one too", "300 es", "#version 300 es\n");
  await page.evaluate(() => Object.defineProperty(navigator, "clipboard",
    { value: { writeText: () => Promise.reject(new Error("refused")) } }));
  await copies("copied where the clipboard is refused", "450", "#version 450\n");

  // What cannot be had is not offered; every text there is, is GLSL.
  await page.locator("#float_bits .text").selectOption({ label: "encode_float_bits" });
  const offered = await page.locator("#float_bits .dialect").evaluate(
    select => [...select.options].filter(option => !option.disabled).map(option => option.value));
  check("dialects that a snippet does not support are not offered",
    () => assert.deepEqual(offered, ["300 es", "310 es", "320 es", "330", "430", "450", "460", "vulkan"]));

  const texts = await page.evaluate(() => [...document.querySelectorAll("script[id]")].map(
    script => ({ label: script.dataset.label, lowest: +script.dataset.lowest, text: script.textContent })));
  check("the page has texts", () => assert.ok(texts.length > 40, String(texts.length)));
  if (existsSync(glslang))
    check("each is a shader in its lowest dialect and in 450", () => {
      const shaders = texts.flatMap(({ label, lowest, text }, i) => [lowest > 0 ? "300 es" : "100", "450"].map(version => {
        const shader = join(work, `${i}-${label}-${version}.frag`.replaceAll(" ", "_"));
        writeFileSync(shader, `#version ${version}\n${text}\nvoid main() {}\n`);
        return shader;
      }));
      const { status, stdout } = spawnSync(glslang, shaders, { encoding: "utf8" });  // one start for all of them
      const wrong = stdout.split("\n").filter((line, i, all) => [line, all[i + 1] ?? ""].some(l => l.startsWith("ERROR")));
      assert.equal(status, 0, wrong.join("\n"));
    });

  // Pictures.
  const images = await page.evaluate(async () => {
    const all = [...document.images];
    await Promise.all(all.map(i => i.decode()));
    const embedded = image => image.src.startsWith("data:image/png;base64,");
    return all.map(image => ({ alt: image.alt, width: image.naturalWidth, embedded: embedded(image) }));
  });
  check("every picture is in the page, has a size and words", () => {
    assert.ok(images.length >= 4 * 3 + 18 * 2 + 12 * 2, String(images.length));
    for (const i of images) assert.ok(i.embedded && i.width > 0 && i.alt.length > 5, JSON.stringify(i));
  });
  for (const system of ["radeon_8500", "dx_sdk", "exercise", "self_shadowing"]) {
    const folder = join(work, system);
    execFileSync(join(originals, system), ["--size", String(size), "--output", folder], { stdio: "pipe" });
    const shown = await page.locator(`#${system} img`).evaluateAll(
      images => images.slice(0, 2).map(image => image.src.split(",")[1]));
    check(system + ": picture and visibility are those of its program", () => {
      assert.ok(Buffer.from(shown[0], "base64").equals(readFileSync(join(folder, "picture.png"))), "picture");
      assert.ok(Buffer.from(shown[1], "base64").equals(readFileSync(join(folder, "visibility.png"))), "visibility");
    });
  }

  for (const soft of ["pcss16", "dpcf16", "vsm", "evsm4", "msm", "summed_variance", "summed_moments"]) {
    const shown = await page.locator("#" + soft).evaluate(article => ({
      pictures: article.querySelectorAll("img").length,
      rows: [...article.querySelectorAll("dd")].map(row => row.textContent) }));
    check(soft + ": soft shadows have pictures, a bias, memory and times", () => {
      assert.equal(shown.pictures, 2);
      assert.equal(shown.rows[0], /^(pcss|dpcf)/.test(soft) ? "receiver_plane" : "acne_free");
      assert.match(shown.rows[1], /^\d+ bytes$/);
      for (const time of shown.rows.slice(2)) assert.match(time, /^[\d.]+ ms$/);
    });
  }

  for (const view of ["indoor", "outdoor", "plain"]) {
    const shown = await page.locator("#" + view).evaluate(article => ({
      captions: [...article.querySelectorAll("figure:has(img) figcaption")].map(caption => caption.textContent) }));
    check(view + ": every setup of a light has a picture with its numbers, the best first", () => {
      assert.ok(shown.captions.length > 10, String(shown.captions.length));
      const means = shown.captions.map(caption => +/: mean ([\d.e+]+), p95 [\d.e+]+$/.exec(caption)[1]);
      assert.deepEqual(means, [...means].sort((a, b) => a - b));
    });
  }

  // As people see it.
  const fits = () => page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
  const desktop = await fits();
  await page.screenshot({ path: join(work, "desktop.png") });
  await page.setViewportSize({ width: 360, height: 740 });
  const phone = await fits();
  await page.screenshot({ path: join(work, "phone.png") });
  check("nothing to scroll sideways, on a desktop or on a phone",
    () => assert.ok(desktop && phone, `${desktop} ${phone}`));
  check("both screenshots are pictures", () => {
    for (const name of ["desktop.png", "phone.png"])
      assert.ok(readFileSync(join(work, name)).length > 10000, name);
  });
  check("the page asks for nothing but itself",
    () => assert.equal(requests.filter(url => !url.startsWith("data:")).length, 1, requests.join(" ")));
  check("no errors", () => assert.deepEqual(said, []));
} finally {
  await context.close();
  rmSync(profile, { recursive: true, force: true });
}
process.exit(problems > 0 ? 1 : 0);
