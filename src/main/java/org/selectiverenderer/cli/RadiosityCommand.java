package org.selectiverenderer.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.RadiosityJob;
import org.selectiverenderer.radiosity.Settings;
import org.selectiverenderer.radiosity.scene.UnlitSceneException;
import org.selectiverenderer.radiosity.solve.EnergyBalance;
import org.selectiverenderer.x3d.Problems;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "radiosity",
    description = {
      "Lights a scene by radiosity: soft shadows and colour bleeding, stored at the vertices.",
      "The scene is left alone. Ctrl-C ends with the last complete iteration."
    },
    footer = {
      "  ./selective-renderer radiosity scenes/apartment-unlit.x3d",
      "  ./selective-renderer radiosity room.x3d --max-mesh 0.5 --quality 85 --preview p.png"
    })
final class RadiosityCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  @Parameters(paramLabel = "SCENE", description = "the X3D scene (.x3d, .x3dz)")
  private Path scene = Path.of("");

  @Option(
      names = "--output",
      paramLabel = "OUT.x3d",
      description = "the lit scene (default: SCENE-lit.x3d beside it)")
  private @Nullable Path output;

  @Option(
      names = "--inline-dir",
      paramLabel = "DIR",
      description =
          "for the lit copies of what it inlines (default: a folder named like OUT in inlineNodes"
              + " beside the scene's folder, else beside OUT)")
  private @Nullable Path inlines;

  @Option(
      names = "--iterations",
      paramLabel = "N",
      description = "number of iterations at most (default: ${DEFAULT-VALUE})")
  private int iterations = Settings.DEFAULT.iterations();

  @Option(
      names = "--quality",
      paramLabel = "P",
      description =
          "initial quality: percent of the energy distributed at which iterations stop (default:"
              + " ${DEFAULT-VALUE})")
  private double quality = Settings.DEFAULT.quality();

  @Option(
      names = "--min-mesh",
      paramLabel = "M",
      description = "minimum mesh size, metres (default: a tenth of the maximum)")
  private @Nullable Double minMesh;

  @Option(
      names = "--max-mesh",
      paramLabel = "M",
      description = "maximum mesh size, metres (default: a 40th of the scene's extent)")
  private @Nullable Double maxMesh;

  @Option(
      names = "--no-global-subdivision",
      description = "surfaces keep their polygons; light is stored at the vertices that are there")
  private boolean noSubdivision;

  @Option(
      names = "--no-regather",
      description = "takes indirect light from the iterations' patches: faster, coarser")
  private boolean noRegather;

  @Option(
      names = "--no-photometric",
      description = "point and spot lights fall off by their attenuation, as X3D draws them")
  private boolean noPhotometric;

  @Option(
      names = "--rays",
      paramLabel = "N",
      description = "rays gathered at each vertex (default: ${DEFAULT-VALUE})")
  private int rays = Settings.DEFAULT.rays();

  @Option(
      names = "--exposure",
      paramLabel = "EV",
      description = "stops brighter or darker than automatic (default: ${DEFAULT-VALUE})")
  private double exposure;

  @Option(
      names = "--max-polygons",
      paramLabel = "N",
      description = "of surfaces without versions after subdivision (default: ${DEFAULT-VALUE})")
  private int maxPolygons = Settings.DEFAULT.maxPolygons();

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "of the rays; the same seed gives the same files (default: ${DEFAULT-VALUE})")
  private int seed = Settings.DEFAULT.seed();

  @Option(
      names = "--preview",
      paramLabel = "F.png",
      description = "a picture from the first viewpoint that refines after every iteration")
  private @Nullable Path preview;

  @Option(
      names = "--format",
      defaultValue = "text",
      description = "of the report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  RadiosityCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    Settings settings = settings();
    Path target = output == null ? RadiosityJob.outputOf(scene) : output;
    OutputFile.check("--output", target, ".x3d");
    OutputFile.check("--preview", preview, ".png");
    if (target.toAbsolutePath().normalize().equals(scene.toAbsolutePath().normalize())) {
      throw CommandFailure.usage("--output names the scene itself, which is left alone");
    }
    Path folder = inlines == null ? RadiosityJob.inlinesOf(target) : inlines;
    try (ProgressBar bar = ProgressBar.on(console())) {
      ExitStatus status = light(new RadiosityJob(scene, target, folder, preview, settings), bar);
      // After Ctrl-C the program ends as soon as the bar is closed.
      console().out().flush();
      return status;
    }
  }

  private ExitStatus light(RadiosityJob job, ProgressBar bar) throws IOException {
    Problems problems = new Problems(console()::problem);
    long start = System.nanoTime();
    try {
      RadiosityJob.Report report =
          job.run(problems, bar, (balance, wanted) -> bar.line(iteration(balance)));
      bar.end();
      print(job.output(), report, (System.nanoTime() - start) / 1e9);
      return ExitStatus.of(problems);
    } catch (UnlitSceneException e) {
      bar.end();
      if (!e.isTold()) {
        String message = String.valueOf(e.getMessage());
        console().message(message.startsWith(scene + ":") ? message : scene + ": " + message);
      }
      return ExitStatus.PROBLEMS;
    }
  }

  private Settings settings() {
    try {
      return new Settings(
          iterations,
          quality,
          size(minMesh),
          size(maxMesh),
          !noSubdivision,
          !noRegather,
          !noPhotometric,
          rays,
          seed,
          exposure,
          maxPolygons);
    } catch (IllegalArgumentException e) {
      throw CommandFailure.usage(e.getMessage());
    }
  }

  private static OptionalDouble size(@Nullable Double metres) {
    return metres == null ? OptionalDouble.empty() : OptionalDouble.of(metres);
  }

  private static String iteration(EnergyBalance balance) {
    return String.format(
        Locale.ROOT,
        "iteration %2d: %5.1f%% distributed; of %.0f lm %.0f absorbed, %.0f escaped, %.0f unshot",
        balance.iteration(),
        balance.distributed(),
        balance.emitted(),
        balance.absorbed(),
        balance.escaped(),
        balance.unshot());
  }

  private void print(Path target, RadiosityJob.Report report, double seconds) {
    if (format == Format.json) {
      ObjectNode node = new ObjectMapper().createObjectNode();
      node.put("output", target.toString()).put("files", report.files());
      node.put("triangles", report.triangles()).put("facets", report.facets());
      node.put("vertices", report.vertices()).put("patches", report.patches());
      node.put("lamps", report.lamps()).put("lumens", Math.round(report.lumens()));
      node.put("iterations", report.balance().iteration());
      node.put("distributed_percent", Math.round(report.balance().distributed() * 100) / 100.0);
      node.put("discrepancy", Math.round(report.balance().discrepancy() * 1e4) / 1e4);
      node.put("rays", report.rays()).put("complete", report.complete());
      node.put("ms", Math.round(seconds * 1000));
      console().out().println(node);
      return;
    }
    console()
        .out()
        .printf(
            Locale.ROOT,
            "%s: %d polygons lit at %d vertices by %d lamps of %.0f lm, %.1f M rays, %.1f s%s%n",
            target,
            report.facets(),
            report.vertices(),
            report.lamps(),
            report.lumens(),
            report.rays() / 1e6,
            seconds,
            report.complete() ? "" : "; cancelled: the light is that of the last iteration");
  }
}
