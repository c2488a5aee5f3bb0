package org.selectiverenderer.apartment.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.selectiverenderer.apartment.ApartmentGenerator;
import org.selectiverenderer.apartment.ApartmentGenerator.Written;
import org.selectiverenderer.apartment.DifferingFilesException;
import org.selectiverenderer.apartment.scene.StreetScene;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.command.output.UndeletedFilesWarning;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "apartment",
    description = {
      "Writes the apartment of the thesis: its scenes, its objects in two versions, its path.",
      "Writes the same bytes every time, all files or none. Keeps files that differ "
          + "unless --force is given."
    },
    footer = {
      "  ./selective-renderer apartment",
      "  ./selective-renderer apartment /tmp/a --only trashCan",
      "  ./selective-renderer apartment /tmp/a --street 16"
    })
final class ApartmentCommand extends CliCommand {
  @Parameters(
      paramLabel = "DIR",
      arity = "0..1",
      defaultValue = ".",
      description = "folder to write scenes/ and inlineNodes/ into (default: the current folder)")
  private Path folder = Path.of("");

  @Option(
      names = "--only",
      split = ",",
      paramLabel = "OBJECT",
      description = "writes only the files of these objects, no scenes")
  private List<String> only = List.of();

  @Option(
      names = "--street",
      split = ",",
      paramLabel = "N",
      description =
          "also writes scenes/street-N.x3d: N times the apartment in rows, to measure programs "
              + "with (1 to 1024)")
  private List<Integer> streets = List.of();

  @Option(names = "--force", description = "replaces files that differ from what is written")
  private boolean force;

  public ApartmentCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    ApartmentGenerator generator = new ApartmentGenerator();
    for (String name : only) {
      if (!generator.objects().contains(name)) {
        throw CommandException.usage("--only: the apartment has no object named " + name);
      }
    }
    if (!streets.isEmpty() && !only.isEmpty()) {
      throw CommandException.usage("--only writes no scenes; leave out --street");
    }
    for (int apartments : streets) {
      if (apartments < 1 || apartments > StreetScene.MOST) {
        throw CommandException.usage(
            "--street must be a whole number from 1 to %d: %d"
                .formatted(StreetScene.MOST, apartments));
      }
    }
    Written written = write(generator);
    if (only.isEmpty()) {
      console().message("apartment: " + written.files() + " files written");
    }
    written
        .polygons()
        .forEach((file, count) -> console().message(file + ": " + Pluralizer.of(count, "polygon")));
    UndeletedFilesWarning.tell(written.left(), console());
    return ExitStatus.DONE;
  }

  private Written write(ApartmentGenerator generator) throws IOException {
    try {
      return only.isEmpty()
          ? generator.writeAll(folder, streets, force)
          : generator.writeObjects(folder, only, force);
    } catch (DifferingFilesException e) {
      throw CommandException.environment(e.getMessage() + " (--force replaces them)");
    }
  }
}
