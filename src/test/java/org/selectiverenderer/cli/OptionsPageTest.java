package org.selectiverenderer.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.command.output.Console;

/** docs/options.md says what the commands' own help says. */
class OptionsPageTest {
  private static final Path PAGE = Path.of("docs/options.md");

  /** {@code mvn test -Dtest=OptionsPageTest -Dreports.update=true} writes the page anew. */
  @Test
  void thePageSaysWhatTheHelpSays() throws IOException {
    PrintStream nowhere = new PrintStream(new ByteArrayOutputStream());
    Console console = new Console(nowhere, nowhere, false);
    var model = new CommandRunner(console).model(CommandCatalogue.commands(console));
    String page = OptionsPageGenerator.of(model.getCommandSpec());
    assertThat(page)
        .contains("\n## simulate\n", "\n### experiment run\n", "| `--rate ", "default: 60")
        .doesNotContain("${", "@|");
    if (Boolean.getBoolean("reports.update")) {
      Files.writeString(PAGE, page);
    }
    assertThat(Files.readString(PAGE).replace("\r\n", "\n"))
        .as("%s; mvn test -Dtest=OptionsPageTest -Dreports.update=true writes it anew", PAGE)
        .isEqualTo(page);
  }
}
