package org.selectiverenderer.enricher.problems;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.selectiverenderer.authoring.DocumentCheck;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.Finding;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.validation.SourceFile;
import org.selectiverenderer.validation.ValidationSettings;
import org.selectiverenderer.validation.run.RuleCatalogue;
import org.selectiverenderer.validation.run.Validator;

/**
 * Checks the unsaved document, with all files that it inlines, as {@code validate} would. Each
 * message ends with the rule in brackets, for {@code validate --explain}.
 */
public final class ValidatorCheck implements DocumentCheck {
  /**
   * Ignored rules: a budget that fits no part of this scene may be meant for another scene of the
   * folder.
   */
  private static final Set<String> OF_OTHER_SCENES = Set.of("SR503");

  private final Supplier<Path> file;
  private final RuleCatalogue rules;
  private final Settings settings;

  /** Reads the validator's settings. */
  @FunctionalInterface
  public interface Settings {
    /**
     * Reads the present settings; called in the background.
     *
     * @param problems collects what is wrong with them
     * @return empty when they cannot be used, so that the defaults apply
     */
    Optional<ValidationSettings> read(ProblemCollector problems) throws IOException;
  }

  /**
   * @param file the document's file, against which urls are resolved; read in the background
   * @param settings of the project
   */
  public ValidatorCheck(Supplier<Path> file, RuleCatalogue rules, Settings settings) {
    this.file = file;
    this.rules = rules;
    this.settings = settings;
  }

  @Override
  public List<Problem> check(DocumentSnapshot snapshot) {
    Path path = file.get().toAbsolutePath();
    Path folder = path.getParent() == null ? path : path.getParent();
    SourceFile source = SourceFile.of(path, SourceFile.of(path, folder).name(), snapshot.bytes());
    ProblemCollector own = new ProblemCollector();
    try {
      ValidationSettings wanted =
          settings.read(own).orElse(ValidationSettings.standard()).ignoring(OF_OTHER_SCENES);
      List<Problem> found = new ArrayList<>(own.list());
      new Validator(rules, wanted, folder)
          .validate(List.of(source)).findings().stream()
              .map(finding -> problem(finding, source.name(), snapshot.name()))
              .forEach(found::add);
      return found;
    } catch (IOException e) {
      SourceLocation whole = SourceLocation.of(snapshot.name());
      return List.of(
          new Problem(
              Problem.Severity.ERROR,
              whole,
              Texts.of("problems.uncheckable", String.valueOf(e.getMessage()))));
    }
  }

  /**
   * Returns another check of one rule, whose findings follow the settings too: none where the rule
   * is ignored, and with the severity that they give it.
   *
   * @param id the rule's id: {@code SR208}
   */
  public DocumentCheck graded(String id, DocumentCheck check) {
    Rule rule = rules.find(id).orElseThrow();
    return snapshot -> {
      ValidationSettings wanted;
      try {
        // What is wrong with them is told once, by the validator's check.
        wanted = settings.read(new ProblemCollector()).orElse(ValidationSettings.standard());
      } catch (IOException e) {
        wanted = ValidationSettings.standard();
      }
      if (wanted.ignores(id)) {
        return List.of();
      }
      Problem.Severity severity = wanted.severity(rule);
      return check.check(snapshot).stream()
          .map(found -> new Problem(severity, found.location(), found.message()))
          .toList();
    };
  }

  private static Problem problem(Finding finding, String main, String document) {
    SourceLocation at = finding.location();
    SourceLocation named =
        at.file().equals(main) ? new SourceLocation(document, at.line(), at.column()) : at;
    String message = "%s [%s]".formatted(finding.message(), finding.rule().id());
    return new Problem(finding.severity(), named, message);
  }
}
