package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.output.Console;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.ArgSpec;

/** Which commands a command line brings up. */
class CommandCatalogueTest {
  private final PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
  private final Console console = new Console(nowhere, nowhere, false);

  @Test
  void eachCommandAloneIsMadeByItsName() {
    for (String name : names(CommandCatalogue.commands(console))) {
      assertThat(names(commands(name, "--help"))).containsExactly(name);
    }
  }

  @Test
  void whatBeginsWithNoCommandGetsAll() {
    int all = CommandCatalogue.commands(console).size();
    assertThat(commands()).hasSize(all);
    assertThat(commands("--debug", "run", "a.x3d")).hasSize(all);
    assertThat(commands("rum", "a.x3d")).hasSize(all);
  }

  @Test
  void onlyASceneThatIsRunIsDrawnAtOnce() {
    assertThat(CommandCatalogue.draws(new String[] {"run", "a.x3d"})).isTrue();
    assertThat(CommandCatalogue.draws(new String[] {"run", "--help"})).isFalse();
    assertThat(CommandCatalogue.draws(new String[] {"run"})).isFalse();
    assertThat(CommandCatalogue.draws(new String[] {"validate", "a.x3d"})).isFalse();
  }

  /** Its words are the same, in the same order, as where nothing needs to be broken. */
  @Test
  void helpFitsIntoATerminalAndBreaksNoWord() {
    var model = new CommandRunner(console).model(CommandCatalogue.commands(console));
    assertThat(all(model).toList())
        .hasSizeGreaterThan(20)
        .allSatisfy(
            command -> {
              String help = command.getUsageMessage();
              assertThat(help.lines()).allSatisfy(line -> assertThat(line).hasSizeLessThan(81));
              command.getCommandSpec().usageMessage().width(2000);
              assertThat(help.split("\\s+"))
                  .containsExactly(command.getUsageMessage().split("\\s+"));
            });
  }

  /** Picocli's own label is the name of a field, which is no word for a user. */
  @Test
  void whatAnOptionTakesHasAWord() {
    var model = new CommandRunner(console).model(CommandCatalogue.commands(console));
    List<ArgSpec> args =
        all(model)
            .flatMap(command -> command.getCommandSpec().args().stream())
            .filter(arg -> !arg.hidden() && arg.arity().max() > 0)
            .toList();
    assertThat(args)
        .hasSizeGreaterThan(100)
        .allSatisfy(arg -> assertThat(arg.paramLabel()).doesNotStartWith("<"));
  }

  private static Stream<CommandLine> all(CommandLine command) {
    return Stream.concat(
        Stream.of(command),
        command.getSubcommands().values().stream().flatMap(CommandCatalogueTest::all));
  }

  /** A line that a terminal breaks is hard to read. */
  @Test
  void examplesFitIntoALineOfTheHelp() {
    var model = new CommandRunner(console).model(CommandCatalogue.commands(console));
    int width = model.getCommandSpec().usageMessage().width();
    assertThat(examples(model))
        .hasSizeGreaterThan(40)
        .allSatisfy(line -> assertThat(line).hasSizeLessThan(width));
  }

  private static List<String> examples(CommandLine command) {
    return all(command)
        .flatMap(each -> Stream.of(each.getCommandSpec().usageMessage().footer()))
        .toList();
  }

  private List<CliCommand> commands(String... args) {
    return CommandCatalogue.commands(console, args);
  }

  private static List<String> names(List<CliCommand> commands) {
    return commands.stream()
        .map(command -> command.getClass().getAnnotation(Command.class).name())
        .toList();
  }
}
