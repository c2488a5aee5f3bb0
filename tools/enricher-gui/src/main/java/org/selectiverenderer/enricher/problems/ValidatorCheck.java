package org.selectiverenderer.enricher.problems;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.document.DocumentCheck;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/**
 * What {@code validate} says of the scene with all that it inlines, as it would be if it were saved
 * now. Each message ends with the rule in brackets, for {@code validate --explain}.
 */
public final class ValidatorCheck implements DocumentCheck {
  private final Supplier<Path> file;
  private final RuleCatalogue rules;
  private final ValidationSettings settings;

  /**
   * @param file where the document is saved, against which its urls count; asked in the background
   */
  public ValidatorCheck(Supplier<Path> file, RuleCatalogue rules, ValidationSettings settings) {
    this.file = file;
    this.rules = rules;
    this.settings = settings;
  }

  @Override
  public List<Problem> check(Snapshot snapshot) {
    Path path = file.get().toAbsolutePath();
    Path folder = path.getParent() == null ? path : path.getParent();
    SourceFile source = SourceFile.of(path, SourceFile.of(path, folder).name(), snapshot.bytes());
    try {
      return new Validator(rules, settings, folder)
          .validate(List.of(source)).findings().stream()
              .map(finding -> problem(finding, source.name(), snapshot.name()))
              .toList();
    } catch (IOException e) {
      Location whole = Location.of(snapshot.name());
      return List.of(
          new Problem(
              Problem.Severity.ERROR, whole, "the scene cannot be checked: " + e.getMessage()));
    }
  }

  private static Problem problem(Finding finding, String main, String document) {
    Location at = finding.location();
    Location named = at.file().equals(main) ? new Location(document, at.line(), at.column()) : at;
    String message = "%s [%s]".formatted(finding.message(), finding.rule().id());
    return new Problem(finding.severity(), named, message);
  }
}
