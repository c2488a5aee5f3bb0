package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.app.examples.ExampleFinder;
import org.selectiverenderer.base.files.SettingsFolder;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.study.definition.StudyTemplate;
import picocli.CommandLine.Command;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.TypeConversionException;

@Command(
    name = "new",
    description = {
      "Writes a new study: study.json with comments, the items of its questionnaires, and a pilot"
          + " study beside it.",
      "The study is that of the thesis: practice, then kitchen, lounge and office "
          + "for 45 s each, rendered high, high-low or selective, with 54 participants."
    },
    footer = {
      "  ./selective-renderer experiment new mystudy",
      "  ./selective-renderer experiment run mystudy/study.json --participant 001",
      "  ./selective-renderer experiment new flicker --design change-blindness"
    })
final class ExperimentNewCommand extends CliCommand {
  private static final String DEFAULT_SCENE = "scenes/apartment-lit.x3d";

  /** The scene that stands in for it where the examples are those that the program brings. */
  private static final String UNLIT_SCENE = "scenes/apartment.x3d";

  static final String GET_EXAMPLES =
      "get the examples with selective-renderer examples DIR, or type this in their folder";

  @Parameters(paramLabel = "DIR", description = "folder of the study; created if it does not exist")
  private Path folder = Path.of("");

  @Option(
      names = "--scene",
      paramLabel = "SCENE",
      description =
          "scene of the study, with practice.x3d beside it (default: "
              + DEFAULT_SCENE
              + ", or where there is none "
              + UNLIT_SCENE
              + ", from here, of the program or of its examples)")
  private @Nullable Path scene;

  /** The example studies, which are in docs/examples. */
  private enum Design {
    change_blindness,
    levels_of_detail,
    quality_and_light,
    rooms_between,
    web;

    @Override
    public String toString() {
      return name().replace('_', '-');
    }
  }

  @Option(
      names = "--design",
      paramLabel = "NAME",
      converter = DesignConverter.class,
      description =
          "copies an example of a design instead: change-blindness (many short trials from a"
              + " list), levels-of-detail (staircases), quality-and-light (2 x 2 within"
              + " participants, Latin square), rooms-between (groups, as in the thesis), web (a short"
              + " study whose participants come by a link)")
  private @Nullable Design design;

  /** Reads the name of a design. */
  static final class DesignConverter implements ITypeConverter<Design> {
    @Override
    public Design convert(String value) {
      return Arrays.stream(Design.values())
          .filter(known -> known.toString().equals(value))
          .findFirst()
          .orElseThrow(
              () ->
                  new TypeConversionException(
                      "'%s' is none of %s"
                          .formatted(
                              value,
                              Arrays.stream(Design.values())
                                  .map(Design::toString)
                                  .collect(Collectors.joining(", ")))));
    }
  }

  ExperimentNewCommand(Console console) {
    super(console);
  }

  @Override
  public ExitStatus run() throws IOException {
    if (design != null) {
      return copy(design);
    }
    Path shown = scene == null ? usual() : scene;
    for (Path needed : List.of(shown, shown.resolveSibling("practice.x3d"))) {
      if (!Files.isRegularFile(needed)) {
        throw CommandException.usage(
            scene == null
                ? "there is no scene "
                    + needed
                    + "; "
                    + GET_EXAMPLES
                    + ", or name a scene of your own with --scene"
                : "--scene: there is no scene " + needed);
      }
    }
    return written(StudyTemplate.write(folder, shown));
  }

  private ExitStatus copy(Design wanted) throws IOException {
    if (scene != null) {
      throw CommandException.usage("--scene is for the study of the thesis; a design has its own");
    }
    String name = "docs/examples/%s/%s".formatted(wanted, StudyTemplate.STUDY);
    Path example =
        examples()
            .find(List.of(name))
            .orElseThrow(
                () -> CommandException.usage("there is no %s; %s".formatted(name, GET_EXAMPLES)));
    ExitStatus status = written(StudyTemplate.copy(example.toAbsolutePath().getParent(), folder));
    if (wanted == Design.web) {
      console()
          .message(
              "change ADDRESS in %s; then: ./selective-renderer experiment export %s --to web %s"
                  .formatted(folder.resolve("form.json"), folder, folder + "-page"));
    }
    return status;
  }

  private ExitStatus written(Path study) throws IOException {
    NewStudyTrust.remember(study, console());
    console().message("study: " + study);
    return ExitStatus.DONE;
  }

  /** Returns the default scene; the best one that there is. */
  static Path usual() {
    return examples().find(List.of(DEFAULT_SCENE, UNLIT_SCENE)).orElse(Path.of(DEFAULT_SCENE));
  }

  private static ExampleFinder examples() {
    return new ExampleFinder(SettingsFolder.ofUser());
  }
}
