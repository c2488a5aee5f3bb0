package org.selectiverenderer.radiosity.reference;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.selectiverenderer.radiosity.LightStorageSettings;
import org.selectiverenderer.radiosity.LightingFixtures;
import org.selectiverenderer.radiosity.RadiositySettings;
import org.selectiverenderer.radiosity.bake.LightingResult;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Renders a scene's light by path tracing and by radiosity from one viewpoint and tells how far
 * they are apart; {@code tools/compare-light} starts it and tells the options.
 */
final class CompareLight {
  private static final List<String> NAMES =
      List.of(
          "--viewpoint",
          "--size",
          "--samples",
          "--seed",
          "--store",
          "--rays",
          "--quality",
          "--out");

  /** Rays through a pixel along each axis. */
  private static final int SIDE = 4;

  private final PrintStream out;

  private CompareLight(PrintStream out) {
    this.out = out;
  }

  public static void main(String[] args) {
    try {
      new CompareLight(System.out).run(args);
    } catch (IOException | RadiosityException | IllegalArgumentException e) {
      System.err.println("compare-light: " + e.getMessage());
      System.exit(2);
    }
  }

  private void run(String[] args) throws IOException, RadiosityException {
    Map<String, String> options = options(args);
    ReferenceScene file = ReferenceScene.read(Path.of(options.get("")));
    RadiosityScene scene = file.scene();
    String[] size = options.getOrDefault("--size", "480x320").split("x");
    if (size.length != 2) {
      throw new IllegalArgumentException("--size is WIDTHxHEIGHT in pixels, such as 480x320");
    }
    PrimaryHits hits =
        PrimaryHits.of(
            scene,
            file.view(options.getOrDefault("--viewpoint", "")),
            number("--size", size[0]),
            number("--size", size[1]),
            SIDE);
    Path folder = Files.createDirectories(Path.of(options.getOrDefault("--out", "compare-light")));
    int seed = number("--seed", options.getOrDefault("--seed", "1"));
    int samples = number("--samples", options.getOrDefault("--samples", "256"));
    ReferenceImage reference = trace(scene, hits, seed, samples, folder);
    ComparisonImages pictures = new ComparisonImages(hits);
    double[] wanted = reference.light();
    Files.write(folder.resolve("reference.pfm"), pictures.floats(wanted));
    String store = options.getOrDefault("--store", "textures");
    if (store.equals("none")) {
      return;
    }
    long begun = System.nanoTime();
    RadiositySettings usual = RadiositySettings.DEFAULT;
    RadiositySettings settings =
        usual.with(
            number("--rays", options.getOrDefault("--rays", "" + usual.rays())),
            percent(options.getOrDefault("--quality", "" + usual.quality())),
            usual.store());
    LightingResult lit = lit(scene, store, settings);
    out.printf(Locale.ROOT, "lit in %.0f s%n", (System.nanoTime() - begun) / 1e9);
    double[] ours = LightingResultRenderer.reflected(scene, hits, Irradiance.of(lit));
    double[] glow = LightingResultRenderer.glowing(scene, hits);
    byte[] left = pictures.shown(sum(ours, glow), lit.curve());
    byte[] middle = pictures.shown(sum(wanted, glow), lit.curve());
    byte[] right = pictures.difference(ours, wanted);
    Files.write(folder.resolve("ours-" + store + ".png"), pictures.png(left));
    Files.write(folder.resolve("reference.png"), pictures.png(middle));
    Files.write(folder.resolve("difference-" + store + ".png"), pictures.png(right));
    Files.write(folder.resolve("compared-" + store + ".png"), pictures.beside(left, middle, right));
    out.print(ImageErrorMetrics.of(hits, ours, reference).text());
    out.print(SurfaceErrorReport.text(scene, hits, ours, wanted));
  }

  private static LightingResult lit(RadiosityScene scene, String store, RadiositySettings settings)
      throws RadiosityException {
    return switch (store) {
      case "textures" -> LightingFixtures.inTextures(scene, settings);
      case "vertices" ->
          LightingFixtures.atVertices(scene, settings.with(LightStorageSettings.VERTICES));
      default ->
          throw new IllegalArgumentException("--store is textures, vertices or none, not " + store);
    };
  }

  /** Goes on with what is in the folder until there are enough samples. */
  private ReferenceImage trace(
      RadiosityScene scene, PrimaryHits hits, int seed, long samples, Path folder)
      throws IOException {
    ReferenceImage picture = new ReferenceImage(scene, hits, seed);
    Path sums = folder.resolve("reference.sums");
    if (Files.exists(sums)) {
      picture.load(sums);
    }
    // Two at least, as noise is told by comparing halves.
    int perPass = ReferenceImage.PATHS * hits.places();
    while (picture.samples() < Math.max(samples, 2 * perPass)) {
      long begun = System.nanoTime();
      picture.pass();
      picture.save(sums);
      out.printf(
          Locale.ROOT,
          "%d of %d samples a pixel; this pass took %.0f s%n",
          picture.samples(),
          samples,
          (System.nanoTime() - begun) / 1e9);
    }
    return picture;
  }

  private static double percent(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("--quality is a number of percent, not " + text, e);
    }
  }

  private static int number(String option, String text) {
    if (!text.matches("[1-9][0-9]{0,5}")) {
      throw new IllegalArgumentException(
          option + " takes whole numbers from 1 to 999999, not " + text);
    }
    return Integer.parseInt(text);
  }

  private static double[] sum(double[] a, double[] b) {
    double[] sum = a.clone();
    for (int i = 0; i < sum.length; i++) {
      sum[i] += b[i];
    }
    return sum;
  }

  private static Map<String, String> options(String[] args) {
    Map<String, String> options = new HashMap<>();
    for (int i = 0; i < args.length; i++) {
      if (!args[i].startsWith("--")) {
        options.put("", args[i]);
      } else if (NAMES.contains(args[i]) && i + 1 < args.length) {
        options.put(args[i], args[++i]);
      } else {
        throw new IllegalArgumentException(
            "what is " + args[i] + "? The options are " + String.join(" X, ", NAMES) + " X");
      }
    }
    if (!options.containsKey("")) {
      throw new IllegalArgumentException("name a scene");
    }
    return options;
  }
}
