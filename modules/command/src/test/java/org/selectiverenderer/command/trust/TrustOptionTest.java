package org.selectiverenderer.command.trust;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.trust.PermissionRequest;
import org.selectiverenderer.base.trust.PermissionRequest.Kind;
import org.selectiverenderer.base.trust.PermissionRequests;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;

class TrustOptionTest {
  @TempDir private Path settings;
  private final ByteArrayOutputStream said = new ByteArrayOutputStream();
  private final PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
  private final Console console = new Console(stream, stream, false);
  private final List<String> questions = new ArrayList<>();

  private static PermissionRequests asking(String host) {
    return new PermissionRequests(
        Path.of("/a"),
        List.of(new PermissionRequest(Kind.HOST, "allowNet", host, "lets scenes fetch " + host)));
  }

  private void require(String host, String typed) {
    TrustPrompt prompt =
        TrustPrompt.onTerminal(
            console,
            question -> {
              questions.add(question);
              return Optional.of(typed);
            });
    new TrustOption()
        .require(Path.of("study.json"), asking(host), prompt, console, new TrustStore(settings));
  }

  @Test
  void theTerminalShowsTheListAndAsksOnce() {
    require("a.org", "y");
    assertThat(said.toString(StandardCharsets.UTF_8))
        .isEqualToNormalizingNewlines(
            "study.json asks for more than its own folder:\n"
                + "  \"allowNet\" lets scenes fetch a.org\n");
    require("a.org", "n");
    assertThat(questions).hasSize(1);
  }

  @Test
  void whatReachesFarthestStandsRightAboveTheQuestion() {
    List<PermissionRequest> all = new ArrayList<>();
    all.add(new PermissionRequest(Kind.FOLDER, "allow", "/", "lets scenes read /"));
    for (int i = 0; i < 300; i++) {
      all.add(new PermissionRequest(Kind.STREAM, "streams", "s" + i, "sends s" + i));
    }
    TrustPrompt prompt =
        TrustPrompt.onTerminal(
            console,
            question -> {
              questions.add(question);
              return Optional.empty();
            });
    PermissionRequests requests = new PermissionRequests(Path.of("/a"), all);
    assertThat(prompt.ask("study.json asks", requests.lines())).isEmpty();
    assertThat(said.toString(StandardCharsets.UTF_8).lines())
        .hasSize(302)
        .last()
        .isEqualTo("  \"allow\" lets scenes read /");
    assertThat(questions).singleElement().asString().startsWith("Agree to all 301? ");
  }

  @Test
  void anythingButYesIsANoWhichIsNotRemembered() {
    for (String typed : List.of("", "n", "maybe yes")) {
      assertThatThrownBy(() -> require("a.org", typed))
          .isInstanceOf(CommandException.class)
          .hasMessage("study.json: not agreed to, so nothing was done");
    }
    assertThat(questions).hasSize(3);
  }

  @Test
  void anotherRequestIsAskedAbout() {
    require("a.org", "yes");
    require("b.org", "yes");
    assertThat(questions).hasSize(2);
  }

  @Test
  void anotherPromptIsTriedWhereOneCanAskNobody() {
    TrustPrompt agrees = (sentence, lines) -> Optional.of(true);
    assertThat(TrustPrompt.NOBODY.or(agrees).ask("", List.of())).contains(true);
    assertThat(TrustPrompt.NOBODY.or(TrustPrompt.NOBODY).ask("", List.of())).isEmpty();
  }
}
