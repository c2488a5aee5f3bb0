package org.selectiverenderer.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.apartment.ApartmentGenerator;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

@Command(
    name = "apartment",
    description = {
      "Writes the apartment of the thesis: its scenes, its objects in two versions, its path.",
      "The same bytes every time."
    },
    footer = {
      "  ./selective-renderer apartment",
      "  ./selective-renderer apartment /tmp/a --only trashCan"
    })
final class ApartmentCommand extends CliCommand {
  @Parameters(
      paramLabel = "DIR",
      arity = "0..1",
      defaultValue = ".",
      description = "gets scenes/ and inlineNodes/ (default: the current folder)")
  private Path folder = Path.of("");

  @Option(
      names = "--only",
      split = ",",
      paramLabel = "OBJECT",
      description = "writes these objects' files and no scenes")
  private List<String> only = List.of();

  ApartmentCommand(Console console) {
    super(console);
  }

  @Override
  ExitStatus run() throws IOException {
    ApartmentGenerator generator = new ApartmentGenerator();
    if (only.isEmpty()) {
      console().message("apartment: " + generator.writeAll(folder) + " files written");
      return ExitStatus.DONE;
    }
    for (String name : only) {
      if (!generator.objects().contains(name)) {
        throw CommandFailure.usage("there is no recipe named " + name);
      }
    }
    Map<String, Integer> written = generator.writeObjects(folder, only);
    written.forEach((file, polygons) -> console().message(file + ": " + polygons + " polygons"));
    return ExitStatus.DONE;
  }
}
