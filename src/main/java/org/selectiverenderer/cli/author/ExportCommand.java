package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;
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
import org.selectiverenderer.export.ExportSettings;
import org.selectiverenderer.export.ExportedScene;
import org.selectiverenderer.export.SceneExporter;
import org.selectiverenderer.export.WebFolder;
import org.selectiverenderer.export.WebScene;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.write.SceneFormat;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "export",
    description = {
      "Writes a copy of an enriched scene that any X3D browser with Scripts renders selectively, or a"
          + " web page that shows it.",
      "The controller becomes a Script of the scene, with ROUTEs from its ProximitySensors and to its"
          + " Switches. All files that the scene names are copied into DIR. Nothing is written when"
          + " something cannot be exported."
    },
    footer = {
      "  ./selective-renderer export scenes/trashcan.x3d --to x3d trashcan-export",
      "  ./selective-renderer export scenes/apartment.x3d --to x3dv apartment-export",
      "  ./selective-renderer export scenes/apartment.x3d --to web apartment-web"
    })
public final class ExportCommand extends CliCommand {
  private enum Form {
    x3d(SceneFormat.XML),
    x3dv(SceneFormat.CLASSIC),
    json(SceneFormat.JSON),
    web(SceneFormat.XML);

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
      description =
          "what is written: the scene as x3d, x3dv or json, with its files in their encodings; or web,"
              + " a page for web browsers")
  private @Nullable Form form;

  @Option(
      names = "--without-script",
      description =
          "controls the scene by filters, triggers and ROUTEs instead of a Script, for browsers that"
              + " run none; areas that decide on the same object must not overlap")
  private boolean withoutScript;

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
    if (withoutScript && to == Form.web) {
      throw CommandException.usage(
          "--without-script: the page is for X_ITE, which runs the Script; leave the option out");
    }
    if (withoutScript && settings.condition() != Condition.SELECTIVE) {
      throw CommandException.usage(
          "--without-script: only the condition selective can do without; leave --condition out");
    }
    if (!Files.exists(scene.file())) {
      throw CommandException.environment(scene.file() + ": there is no such file");
    }
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw CommandException.environment("DIR %s: is a file, not a folder".formatted(folder));
    }
    ProblemCollector problems = new ProblemCollector(console()::problem);
    ExportSettings how =
        new ExportSettings(
            settings.condition(),
            (int) settings.seed(),
            to.format,
            to == Form.web ? WebScene::name : UnaryOperator.identity(),
            !withoutScript);
    Optional<ExportedScene> exported =
        new SceneExporter(NodeCatalogue.load(), access.access(), problems)
            .export(scene.file(), how, name(to));
    if (exported.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    for (ScenePackage.LeftOut left : exported.get().files().left()) {
      problems.error(
          SourceLocation.of(left.file()),
          "url '%s' %s; the export would lack it".formatted(left.url(), left.reason()));
    }
    if (problems.anyError()) {
      return ExitStatus.PROBLEMS;
    }
    return to == Form.web
        ? writePage(exported.get(), settings)
        : writeScene(exported.get().files());
  }

  private String name(Form to) {
    String name = String.valueOf(scene.file().getFileName());
    int dot = name.indexOf('.', 1);
    String stem = dot < 0 ? name : name.substring(0, dot);
    return to == Form.web ? WebScene.name(stem + ".x3d") : stem + "." + to;
  }

  private ExitStatus writeScene(ScenePackage exported) throws IOException {
    List<PackagedFile> files = new ArrayList<>(List.of(exported.scene()));
    files.addAll(exported.files());
    write(files);
    console()
        .line(
            "%s: %s"
                .formatted(
                    folder.resolve(exported.scene().target()),
                    Pluralizer.of(exported.files().size(), "other file")));
    return ExitStatus.DONE;
  }

  private ExitStatus writePage(ExportedScene exported, SelectiveController.Settings settings)
      throws IOException {
    WebFolder web =
        WebFolder.around(exported, settings.condition(), (int) settings.seed())
            .orElseThrow(
                () ->
                    CommandException.environment(
                        "--to web: this program was built without the page; install Node.js 20 or"
                            + " later with npm, and build it again"));
    List<PackagedFile> files = new ArrayList<>(web.page());
    files.addAll(web.scene());
    write(files);
    console().line("%s: a page for any web server".formatted(folder.resolve("index.html")));
    console()
        .line(
            "  the scene: %s in %s; its texts had %s before compression"
                .formatted(
                    size(web.sceneBytes()),
                    Pluralizer.of(web.scene().size(), "file"),
                    size(web.plainBytes())));
    console()
        .line(
            "  the page: %s, and %s that are loaded where a scene needs them"
                .formatted(size(web.pageBytes()), size(web.partBytes())));
    return ExitStatus.DONE;
  }

  private static String size(long bytes) {
    return bytes < 1_000_000
        ? String.format(Locale.ROOT, "%.0f kB", bytes / 1e3)
        : String.format(Locale.ROOT, "%.1f MB", bytes / 1e6);
  }

  private void write(List<PackagedFile> files) throws IOException {
    List<Path> conflicts = PackageWriter.conflicts(files, folder);
    if (!conflicts.isEmpty()) {
      throw CommandException.environment(
          "DIR %s: has another %s already; name a new or empty folder"
              .formatted(folder, folder.relativize(conflicts.get(0))));
    }
    PackageWriter.intoFolder(files, folder, share -> {}).keep();
  }
}
