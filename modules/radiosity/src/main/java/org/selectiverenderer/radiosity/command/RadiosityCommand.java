package org.selectiverenderer.radiosity.command;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.base.markup.ControlCharacterEscaper;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.option.SceneArgument;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.radiosity.LightStorageSettings;
import org.selectiverenderer.radiosity.LightmapReport;
import org.selectiverenderer.radiosity.RadiosityJob;
import org.selectiverenderer.radiosity.RadiositySettings;
import org.selectiverenderer.radiosity.scene.RadiosityException;
import org.selectiverenderer.radiosity.solve.EnergyBalance;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

@Command(
    name = "radiosity",
    description = {
      "Lights a scene by radiosity: soft shadows and colour bleeding, stored in pictures.",
      "Does not change the scene. Ctrl-C ends the computation and writes the last "
          + "complete iteration."
    },
    footer = {
      "  ./selective-renderer radiosity scenes/apartment-unlit.x3d",
      "  ./selective-renderer radiosity room.x3d --max-mesh 0.5 --quality 85 \\",
      "      --preview p.png"
    })
final class RadiosityCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  private enum Store {
    textures,
    vertices
  }

  @Mixin private SceneArgument scene = new SceneArgument();

  @Mixin private AccessOptions access = new AccessOptions();

  @Option(
      names = "--output",
      paramLabel = "OUT.x3d",
      description = "file of the lit scene (default: SCENE-lit.x3d beside the scene)")
  private @Nullable Path output;

  @Option(
      names = "--inline-dir",
      paramLabel = "DIR",
      description =
          "folder of the lit copies of inlined files (default: a folder named like "
              + "OUT in inlineNodes beside the scene's folder, else beside OUT)")
  private @Nullable Path inlines;

  @Option(
      names = "--store",
      paramLabel = "PLACE",
      description =
          "where the light is stored: in pictures beside the lit files, or in the colours of the "
              + "vertices; ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Store store = Store.textures;

  @Option(
      names = "--texels-per-metre",
      paramLabel = "D",
      description =
          "texels per metre of large surfaces; small ones get more (default: 40, fewer where the "
              + "budget asks for it)")
  private @Nullable Double texels;

  @Option(
      names = "--texture-budget",
      paramLabel = "MB",
      description =
          "largest size of all pictures together in memory; their files are smaller (default: "
              + "${DEFAULT-VALUE})")
  private double megabytes = LightStorageSettings.DEFAULT.megabytes();

  @Option(
      names = "--noise",
      paramLabel = "P",
      description =
          "target for the mean noise of the light pictures, percent: noisier texels get "
              + "more rays, up to half as many again in all (default: ${DEFAULT-VALUE})")
  private double noise = LightStorageSettings.DEFAULT.noise();

  @Option(
      names = "--no-highlights",
      description = "switches all lights off: shapes that shine lose their highlights")
  private boolean noHighlights;

  @Option(
      names = "--iterations",
      paramLabel = "N",
      description = "largest number of iterations (default: ${DEFAULT-VALUE})")
  private int iterations = RadiositySettings.DEFAULT.iterations();

  @Option(
      names = "--quality",
      paramLabel = "P",
      description =
          "initial quality: percent of the energy to distribute before the "
              + "iterations stop (default: ${DEFAULT-VALUE})")
  private double quality = RadiositySettings.DEFAULT.quality();

  @Option(
      names = "--min-mesh",
      paramLabel = "M",
      description =
          "minimum mesh size, metres; for light at vertices (default: a tenth of the maximum)")
  private @Nullable Double minMesh;

  @Option(
      names = "--max-mesh",
      paramLabel = "M",
      description =
          "maximum mesh size, metres; patches are 0.4 of it (default: a 40th of the scene's extent)")
  private @Nullable Double maxMesh;

  @Option(
      names = "--no-global-subdivision",
      description =
          "does not subdivide surfaces, even where the scene asks for a number of polygons")
  private boolean noSubdivision;

  @Option(
      names = "--no-regather",
      description =
          "takes indirect light from the iterations' patches, without final gathering: faster,"
              + " coarser")
  private boolean noRegather;

  @Option(
      names = "--no-photometric",
      description = "lets point and spot lights fall off by their attenuation, as X3D draws them")
  private boolean noPhotometric;

  @Option(
      names = "--rays",
      paramLabel = "N",
      description =
          "number of final-gathering rays at each vertex, or at each sample between which the "
              + "light at texels is interpolated (default: ${DEFAULT-VALUE})")
  private int rays = RadiositySettings.DEFAULT.rays();

  @Option(
      names = "--exposure",
      paramLabel = "EV",
      description =
          "exposure in stops, brighter or darker than the automatic one (default: "
              + "${DEFAULT-VALUE})")
  private double exposure;

  @Option(
      names = "--max-polygons",
      paramLabel = "N",
      description =
          "largest number of polygons of surfaces without versions after subdivision "
              + "(default: ${DEFAULT-VALUE})")
  private int maxPolygons = RadiositySettings.DEFAULT.maxPolygons();

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "seed of the rays; the same seed gives the same files (default: ${DEFAULT-VALUE})")
  private int seed = RadiositySettings.DEFAULT.seed();

  @Option(
      names = "--preview",
      paramLabel = "F.png",
      description =
          "writes a picture from the first viewpoint and refines it after every iteration")
  private @Nullable Path preview;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "format of the report: ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE})")
  private Format format = Format.text;

  public RadiosityCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    RadiositySettings settings = settings();
    Path target = output == null ? RadiosityJob.outputOf(scene.file()) : output;
    OutputFile.check("--output", target, ".x3d");
    OutputFile.check("--preview", preview, ".png");
    if (target.toAbsolutePath().normalize().equals(scene.file().toAbsolutePath().normalize())) {
      throw CommandException.usage(
          "--output is the scene itself, which is not overwritten; name another file");
    }
    Path folder = inlines == null ? RadiosityJob.inlinesOf(target) : inlines;
    try (ProgressBar bar = ProgressBar.on(console())) {
      ExitStatus status =
          light(
              new RadiosityJob(scene.file(), access.access(), target, folder, preview, settings),
              bar);
      // After Ctrl-C the program ends as soon as the bar is closed.
      console().out().flush();
      return status;
    }
  }

  private ExitStatus light(RadiosityJob job, ProgressBar bar) throws IOException {
    ProblemCollector problems = new ProblemCollector(console()::problem);
    long start = System.nanoTime();
    try {
      RadiosityJob.Report report =
          job.run(problems, bar, (balance, wanted) -> bar.line(iteration(balance)));
      bar.end();
      print(job.output(), report, (System.nanoTime() - start) / 1e9);
      return ExitStatus.of(problems);
    } catch (RadiosityException e) {
      bar.end();
      if (!e.isTold()) {
        String message = String.valueOf(e.getMessage());
        console()
            .message(
                message.startsWith(scene.file() + ":") ? message : scene.file() + ": " + message);
      }
      return ExitStatus.PROBLEMS;
    }
  }

  private RadiositySettings settings() {
    try {
      return new RadiositySettings(
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
          maxPolygons,
          new LightStorageSettings(
              store == Store.textures
                  ? LightStorageSettings.Kind.TEXTURES
                  : LightStorageSettings.Kind.VERTICES,
              size(texels),
              megabytes,
              !noHighlights,
              noise));
    } catch (IllegalArgumentException e) {
      throw CommandException.usage(e.getMessage());
    }
  }

  private static OptionalDouble size(@Nullable Double given) {
    return given == null ? OptionalDouble.empty() : OptionalDouble.of(given);
  }

  private static String iteration(EnergyBalance balance) {
    return String.format(
        Locale.ROOT,
        "iteration %2d: %5.1f%% distributed; of %.0f lm %.0f absorbed, %.0f escaped, "
            + "%.0f not yet passed on",
        balance.iteration(),
        balance.distributed(),
        balance.emitted(),
        balance.absorbed(),
        balance.escaped(),
        balance.unshot());
  }

  private void print(Path target, RadiosityJob.Report report, double seconds) {
    LightmapReport pictures = report.pictures();
    if (format == Format.json) {
      ObjectNode node = JsonTree.object();
      node.put("output", target.toString()).put("files", report.files());
      node.put("triangles", report.triangles()).put("facets", report.facets());
      node.put("vertices", report.vertices()).put("patches", report.patches());
      node.put("lamps", report.lamps()).put("lumens", Math.round(report.lumens()));
      node.put("iterations", report.balance().iteration());
      node.put("distributed_percent", DecimalRounding.to(2, report.balance().distributed()));
      node.put("discrepancy", DecimalRounding.to(4, report.balance().discrepancy()));
      node.put("rays", report.rays()).put("complete", report.complete());
      if (pictures != null) {
        print(node.putObject("pictures"), pictures);
      }
      node.put("ms", Math.round(seconds * 1000));
      console().line(node.toString());
      return;
    }
    console()
        .out()
        .printf(
            Locale.ROOT,
            "%s: %d polygons lit %s by %d lamps of %.0f lm, %.1f M rays, %.1f s%s%n",
            ControlCharacterEscaper.line(target.toString()),
            report.facets(),
            pictures == null
                ? "at %d vertices".formatted(report.vertices())
                : "in %d picture%s".formatted(pictures.files(), pictures.files() == 1 ? "" : "s"),
            report.lamps(),
            report.lumens(),
            report.rays() / 1e6,
            seconds,
            report.complete() ? "" : "; cancelled: the light is that of the last iteration");
    if (pictures != null) {
      print(pictures);
    }
  }

  private void print(ObjectNode node, LightmapReport pictures) {
    node.put("files", pictures.files()).put("bytes", pictures.bytes());
    node.put("texels", pictures.texels());
    node.put("least_texels_per_metre", DecimalRounding.to(1, pictures.leastPerMetre()));
    node.put("most_texels_per_metre", DecimalRounding.to(1, pictures.mostPerMetre()));
    node.put("noise_mean_percent", DecimalRounding.to(2, 100 * pictures.noise().mean()));
    node.put("noise_most_percent", DecimalRounding.to(2, 100 * pictures.noise().most()));
    node.put("noise_wished_percent", noise);
    node.put("multiplied", pictures.multiplied()).put("shining", pictures.shining());
  }

  private void print(LightmapReport pictures) {
    console()
        .out()
        .printf(
            Locale.ROOT,
            "  pictures: %.1f M texels, %.0f to %.0f per metre, %.1f MB, noise %.1f %% (95 in 100"
                + " below %.1f %%)%s; %d shapes keep their textures, %d their highlights%n",
            pictures.texels() / 1e6,
            pictures.leastPerMetre(),
            pictures.mostPerMetre(),
            pictures.bytes() / 1e6,
            100 * pictures.noise().mean(),
            100 * pictures.noise().most(),
            wish(pictures.noise().mean()),
            pictures.multiplied(),
            pictures.shining());
  }

  private String wish(double mean) {
    return 100 * mean <= noise
        ? ""
        : String.format(Locale.ROOT, ", above the target of %.1f %%: raise --rays", noise);
  }
}
