package org.selectiverenderer.cli.author;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.json.JsonTree;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.cli.base.CliCommand;
import org.selectiverenderer.cli.output.CommandFailure;
import org.selectiverenderer.cli.output.Console;
import org.selectiverenderer.cli.output.ExitStatus;
import org.selectiverenderer.cli.output.OutputFile;
import org.selectiverenderer.polygon.model.Model;
import org.selectiverenderer.polygon.model.ModelReader;
import org.selectiverenderer.polygon.model.ModelWriter;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.simplify.ModelSize;
import org.selectiverenderer.polygon.simplify.Simplified;
import org.selectiverenderer.polygon.simplify.Simplifier;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.Gzip;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "simplify",
    description = {
      "Makes one reduced version of a model: X3D, OBJ, PLY, STL or glTF to X3D.",
      "Without --output the model goes to standard output, and the figures to standard error; with"
          + " --format json and no --output only the figures are printed."
    },
    footer = {
      "  ./selective-renderer simplify inlineNodes/trashCan_v1.x3d --vert-percent 10 --output"
          + " trashCan_v2.x3d",
      "  ./selective-renderer simplify chair.glb --polygons 500 --output chair_v2.x3d"
    })
public final class SimplifyCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  /** One of the ways to say how far to reduce. */
  static final class GoalOptions {
    @Option(
        names = "--vert-percent",
        paramLabel = "P",
        description = "share of the vertices to keep, in percent (Vert Percent)")
    private @Nullable Double vertPercent;

    @Option(
        names = "--vert-count",
        paramLabel = "N",
        description = "number of vertices to keep (Vert Count)")
    private @Nullable Integer vertCount;

    @Option(names = "--polygons", paramLabel = "N", description = "number of polygons to keep")
    private @Nullable Integer polygons;

    @Option(
        names = "--max-error",
        paramLabel = "E",
        description = "largest error allowed, as a share of the model's largest extent")
    private @Nullable Double maxError;

    Goal goal() {
      if (vertPercent != null) {
        return GoalText.percent(vertPercent);
      }
      if (vertCount != null) {
        return GoalText.vertices(vertCount);
      }
      return polygons != null ? GoalText.polygons(polygons) : GoalText.error(maxError);
    }
  }

  @Parameters(
      paramLabel = "MODEL",
      description = "model (.x3d, .x3dz, .obj, .ply, .stl, .gltf, .glb)")
  private Path file = Path.of("");

  @ArgGroup(exclusive = true, multiplicity = "1")
  private GoalOptions options = new GoalOptions();

  @Option(names = "--output", paramLabel = "OUT.x3d", description = "writes the model to a file")
  private @Nullable Path output;

  @Option(
      names = "--format",
      description = "format of the figures: ${COMPLETION-CANDIDATES} (default: text)")
  private @Nullable Format format;

  public SimplifyCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    Goal goal = options.goal();
    OutputFile.check("--output", output, ".x3d", ".x3dz");
    if (output != null
        && Files.exists(output)
        && Files.exists(file)
        && Files.isSameFile(output, file)) {
      throw CommandFailure.environment(
          "--output " + output + ": is the model itself, which would be lost; name another file");
    }
    Problems problems = new Problems(console()::problem);
    Optional<Model> read = new ModelReader(NodeCatalogue.load()).read(file, problems);
    if (read.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    Model model = read.get();
    ModelSize size = ModelSize.of(model.meshes());
    if (GoalText.beyond(goal, size, file, problems)) {
      return ExitStatus.PROBLEMS;
    }
    long start = System.nanoTime();
    Simplified reduced = new Simplifier().simplify(model.meshes(), goal);
    long milliseconds = (System.nanoTime() - start) / 1_000_000;
    write(model.with(reduced.parts()), reduced);
    print(size, reduced, milliseconds);
    if (!reduced.met()) {
      console().message(GoalText.shortfall(file.toString(), goal, reduced));
    }
    return reduced.met() ? ExitStatus.of(problems) : ExitStatus.PROBLEMS;
  }

  private void write(Model model, Simplified reduced) throws IOException {
    Path target = output == null ? Path.of("model.x3d") : output;
    if (output == null && format == Format.json) {
      return;
    }
    Path folder = target.toAbsolutePath().getParent();
    String text =
        new ModelWriter()
            .text(
                model,
                folder == null ? target.toAbsolutePath() : folder,
                String.valueOf(target.getFileName()),
                "%s, reduced to %s"
                    .formatted(file.getFileName(), GoalText.polygonText(reduced.polygons())));
    if (output == null) {
      console().out().print(text);
      return;
    }
    FileTransaction writing = new FileTransaction();
    byte[] plain = text.getBytes(StandardCharsets.UTF_8);
    boolean packed = output.toString().toLowerCase(Locale.ROOT).endsWith(".x3dz");
    writing.add(output, packed ? Gzip.packed(plain) : plain);
    LeftFiles.tell(writing.commit(), console());
  }

  private void print(ModelSize size, Simplified reduced, long milliseconds) {
    if (format == Format.json) {
      ObjectNode report = JsonTree.object();
      report.putObject("input").put("vertices", size.vertices()).put("polygons", size.polygons());
      report
          .putObject("output")
          .put("vertices", reduced.vertices())
          .put("polygons", reduced.polygons());
      report.put("error", reduced.error()).put("ms", milliseconds);
      console().out().println(report);
      return;
    }
    String text =
        String.format(
            Locale.ROOT,
            "Max Vertex     %9d   polygons %9d%n"
                + "Vert Count     %9d   polygons %9d%n"
                + "Vert Percent   %8.1f%%            %8.1f%%%n"
                + "largest error  %8.3f%%  of the model's largest extent%n"
                + "took           %9d ms%n",
            size.vertices(),
            size.polygons(),
            reduced.vertices(),
            reduced.polygons(),
            100.0 * reduced.vertices() / size.vertices(),
            100.0 * reduced.polygons() / size.polygons(),
            100 * reduced.error(),
            milliseconds);
    (output == null ? console().err() : console().out()).print(text);
  }
}
