package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.packaging.PackageWriter;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.cli.option.ConditionOptions;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.option.AccessOptions;
import org.selectiverenderer.command.option.SceneArgument;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.export.SceneExporter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.write.SceneFormat;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "export",
    description = {
      "Writes a copy of an enriched scene that any X3D browser with Scripts renders selectively.",
      "The controller becomes a Script of the scene, with ROUTEs from its ProximitySensors and to its"
          + " Switches. All files that the scene names are copied into DIR. Nothing is written when"
          + " something cannot be exported."
    },
    footer = {
      "  ./selective-renderer export scenes/trashcan.x3d --to x3d trashcan-export",
      "  ./selective-renderer export scenes/apartment.x3d --to x3dv apartment-export"
    })
public final class ExportCommand extends CliCommand {
  private enum Form {
    x3d(SceneFormat.XML),
    x3dv(SceneFormat.CLASSIC),
    json(SceneFormat.JSON);

    private final SceneFormat format;

    Form(SceneFormat format) {
      this.format = format;
    }
  }

  @Mixin private SceneArgument scene = new SceneArgument();

  @Parameters(paramLabel = "DIR", index = "1", description = "folder to write, new or empty")
  private Path folder = Path.of("");

  @Option(
      names = "--to",
      paramLabel = "FORM",
      required = true,
      description = "encoding of the scene: ${COMPLETION-CANDIDATES}; its files keep theirs")
  private @Nullable Form form;

  @Mixin private ConditionOptions condition = new ConditionOptions();

  @Mixin private AccessOptions access = new AccessOptions();

  public ExportCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    Form to = form == null ? Form.x3d : form;
    SelectiveController.Settings settings = condition.settings();
    if (settings.seed() != (int) settings.seed()) {
      throw CommandException.usage(
          "--seed %d: the field of the exported Script holds whole numbers of 32 bits, from %d to %d"
              .formatted(settings.seed(), Integer.MIN_VALUE, Integer.MAX_VALUE));
    }
    if (!Files.exists(scene.file())) {
      throw CommandException.environment(scene.file() + ": there is no such file");
    }
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw CommandException.environment("DIR %s: is a file, not a folder".formatted(folder));
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    Optional<ScenePackage> exported =
        new SceneExporter(NodeCatalogue.load(), access.access(), problems)
            .export(scene.file(), settings.condition(), (int) settings.seed(), to.format, name(to));
    if (exported.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    for (ScenePackage.LeftOut left : exported.get().left()) {
      problems.error(
          SourceLocation.of(left.file()),
          "url '%s' %s; the export would lack it".formatted(left.url(), left.reason()));
    }
    return problems.anyError() ? ExitStatus.PROBLEMS : write(exported.get());
  }

  private String name(Form to) {
    String name = String.valueOf(scene.file().getFileName());
    int dot = name.indexOf('.', 1);
    return (dot < 0 ? name : name.substring(0, dot)) + "." + to;
  }

  private ExitStatus write(ScenePackage exported) throws IOException {
    List<PackagedFile> files = new ArrayList<>(List.of(exported.scene()));
    files.addAll(exported.files());
    List<Path> conflicts = PackageWriter.conflicts(files, folder);
    if (!conflicts.isEmpty()) {
      throw CommandException.environment(
          "DIR %s: has another %s already; name a new or empty folder"
              .formatted(folder, folder.relativize(conflicts.get(0))));
    }
    PackageWriter.intoFolder(files, folder, share -> {});
    console()
        .line(
            "%s: %s"
                .formatted(
                    folder.resolve(exported.scene().target()),
                    Pluralizer.of(exported.files().size(), "other file")));
    return ExitStatus.DONE;
  }
}
