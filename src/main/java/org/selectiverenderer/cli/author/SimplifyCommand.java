package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.files.FileFinder;
import org.selectiverenderer.cli.batch.BatchOutputFormat;
import org.selectiverenderer.cli.batch.BatchRunner;
import org.selectiverenderer.cli.option.FileArguments;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.OutputFile;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "simplify",
    description = {
      "Makes one reduced version of a model: X3D, glTF, OBJ, PLY, STL, COLLADA or FBX to X3D.",
      "Without --output the model goes to standard output, and the figures to standard error; with"
          + " --format json and no --output only the figures are printed.",
      "Processes several models in parallel, one on each processor."
    },
    footer = {
      "  ./selective-renderer simplify inlineNodes/trashCan_v1.x3d --vert-percent 10 \\",
      "      --output can.x3d",
      "  ./selective-renderer simplify inlineNodes/deskChair.x3d --polygons 500 \\",
      "      --output deskChair_v2.x3d",
      "  ./selective-renderer simplify inlineNodes/ --vert-percent 10 \\",
      "      --output-dir reduced"
    })
public final class SimplifyCommand extends CliCommand {
  private enum Format {
    text,
    json
  }

  private static final FileFinder MODELS =
      new FileFinder(
          "model",
          List.of(".x3d", ".x3dz", ".obj", ".ply", ".stl", ".gltf", ".glb", ".dae", ".fbx"));

  /** The exclusive options for the goal of the reduction. */
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

    SimplificationTarget goal() {
      if (vertPercent != null) {
        return ReductionGoalOptions.percent(vertPercent);
      }
      if (vertCount != null) {
        return ReductionGoalOptions.vertices(vertCount);
      }
      return polygons != null
          ? ReductionGoalOptions.polygons(polygons)
          : ReductionGoalOptions.error(maxError);
    }
  }

  @Parameters(
      paramLabel = "MODEL",
      arity = "1..*",
      description =
          "models (.x3d, .x3dz, .gltf, .glb, .obj, .ply, .stl, .dae, .fbx), folders of models,"
              + " patterns")
  private List<String> names = List.of();

  @Mixin private AccessOptions access = new AccessOptions();

  @ArgGroup(exclusive = true, multiplicity = "1")
  private GoalOptions options = new GoalOptions();

  @Option(names = "--output", paramLabel = "OUT.x3d", description = "writes the model to a file")
  private @Nullable Path output;

  @Option(
      names = "--output-dir",
      paramLabel = "DIR",
      description = "writes each model to a file in a folder, named as the model, with .x3d")
  private @Nullable Path outputDir;

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      description = "format of the figures: ${COMPLETION-CANDIDATES} (default: text)")
  private @Nullable Format format;

  public SimplifyCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    SimplificationTarget goal = options.goal();
    OutputFile.check("--output", output, ".x3d", ".x3dz");
    if (output != null && outputDir != null) {
      throw CommandException.usage("--output and --output-dir exclude each other; give one");
    }
    ContentAccessPolicy allowed = access.access();
    try (ModelReader reader = new ModelReader(NodeCatalogue.load(), allowed)) {
      return reduce(goal, allowed, reader);
    }
  }

  private ExitStatus reduce(
      SimplificationTarget goal, ContentAccessPolicy allowed, ModelReader reader)
      throws IOException {
    FileArguments files = new FileArguments(names);
    if (files.one()) {
      Path file = files.file();
      Path target =
          outputDir == null ? output : OutputFolder.open(outputDir, List.of(file)).of(file);
      if (target != null
          && Files.exists(target)
          && Files.exists(file)
          && Files.isSameFile(target, file)) {
        throw CommandException.environment(
            "--output " + target + ": is the model itself, which would be lost; name another file");
      }
      return new ModelReduction(goal, reader, allowed, target, format == Format.json, false)
          .run(file, console());
    }
    if (output != null || outputDir == null && format != Format.json) {
      throw CommandException.usage("several models need --output-dir, a folder for the results");
    }
    List<Path> models = files.files(MODELS);
    OutputFolder folder = outputDir == null ? null : OutputFolder.open(outputDir, models);
    boolean json = format == Format.json;
    return new BatchRunner(console(), json ? BatchOutputFormat.JSON_ARRAY : BatchOutputFormat.TEXTS)
        .run(
            models,
            (model, own) ->
                new ModelReduction(
                        goal, reader, allowed, folder == null ? null : folder.of(model), json, true)
                    .run(model, own));
  }
}
