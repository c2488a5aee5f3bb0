package org.selectiverenderer.cli.experiment;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The option that chooses one of a study's languages. */
final class LanguageOption {
  @Option(
      names = "--language",
      paramLabel = "CODE",
      description =
          "one of the study's \"languages\", in which the participant reads and answers (default:"
              + " that of the participant's sessions so far, else the first)")
  private @Nullable String language;

  /** Returns the language as typed. */
  Optional<String> typed() {
    return Optional.ofNullable(language);
  }
}
