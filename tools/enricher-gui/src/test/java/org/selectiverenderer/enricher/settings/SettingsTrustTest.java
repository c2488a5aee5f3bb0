package org.selectiverenderer.enricher.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.trust.TrustStore;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.settings.ValidationSettingsReader;

/** What a settings file that comes with a scene may open. */
class SettingsTrustTest {
  @TempDir private Path folder;
  private Path file;
  private final List<String> questions = new ArrayList<>();
  private final List<Consumer<Boolean>> answers = new ArrayList<>();
  private final List<String> again = new ArrayList<>();

  @BeforeEach
  void settings() throws IOException {
    Files.createDirectories(folder.resolve("sent/parts"));
    Files.createDirectories(folder.resolve("private"));
    file = folder.resolve("sent/.selective-renderer-validate.json");
  }

  private SettingsTrust trust() {
    return new SettingsTrust(
        new TrustStore(folder.resolve("settings")),
        (sentence, lines, answer) -> {
          questions.addAll(lines);
          answers.add(answer);
        });
  }

  private List<Path> opened(SettingsTrust trust, String keys) throws IOException {
    Files.writeString(file, keys);
    ValidationSettings read =
        new ValidationSettingsReader(file, RuleCatalogue.standard())
            .read(new ProblemCollector())
            .orElseThrow();
    return trust.limited(read, new ProblemCollector(), () -> again.add("again")).access().folders();
  }

  @Test
  void whatIsOutsideIsLeftOutUntilTheAuthorAgreesAndIsAskedOnce() throws IOException {
    SettingsTrust trust = trust();
    String keys = "{\"allow\": [\"../private\"], \"allowNet\": [\"example.org\"]}";
    assertThat(opened(trust, keys)).isEmpty();
    assertThat(opened(trust, keys)).isEmpty();
    assertThat(questions)
        .containsExactly(
            "\"allow\" lets scenes read every file in and below "
                + folder.toRealPath().resolve("private"),
            "\"allowNet\" lets scenes fetch files from example.org");
    answers.get(0).accept(true);
    assertThat(again).containsExactly("again");
    assertThat(opened(trust, keys)).hasSize(1);
    assertThat(opened(trust(), keys)).as("in another window").hasSize(1);
    assertThat(answers).hasSize(1);
  }

  @Test
  void aRefusalHoldsAndOtherRequestsAreAskedAbout() throws IOException {
    SettingsTrust trust = trust();
    assertThat(opened(trust, "{\"allow\": [\"../private\"]}")).isEmpty();
    answers.get(0).accept(false);
    assertThat(opened(trust, "{\"allow\": [\"../private\"], \"megabytes\": 5}")).isEmpty();
    assertThat(answers).hasSize(1);
    assertThat(opened(trust, "{\"allow\": [\"..\"]}")).isEmpty();
    assertThat(answers).hasSize(2);
  }

  @Test
  void itsOwnFoldersAreOpenWithoutAQuestion() throws IOException {
    assertThat(opened(trust(), "{\"allow\": [\"parts\"]}")).hasSize(1);
    assertThat(questions).isEmpty();
  }
}
