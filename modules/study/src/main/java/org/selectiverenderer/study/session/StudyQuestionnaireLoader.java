package org.selectiverenderer.study.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyPermissions;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Content;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Moment;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Source;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.questionnaire.Questionnaire;
import org.selectiverenderer.study.questionnaire.read.ItemListReader;
import org.selectiverenderer.study.questionnaire.read.LocalizedTexts;
import org.selectiverenderer.study.questionnaire.read.QuestionnaireReader;
import org.selectiverenderer.study.questionnaire.read.StandardScales;
import org.selectiverenderer.study.session.LoadedStudy.Asked;

/**
 * Loads the questionnaires that a study refers to, and reports the faults of all of them at once.
 */
final class StudyQuestionnaireLoader {
  private final Study study;
  private final ParticipantMessages wording;
  private final ProblemCollector problems;

  StudyQuestionnaireLoader(Study study, ParticipantMessages wording, ProblemCollector problems) {
    this.study = study;
    this.wording = wording;
    this.problems = problems;
  }

  /** Loads the form of the study, else the built-in one; empty after a fault. */
  Optional<Questionnaire> form() throws IOException {
    Optional<Questionnaire> read =
        study.questionnaires().form().isPresent()
            ? own(study.questionnaires().form().get())
            : standard(StandardScales.FORM);
    return read.map(form -> form.as("form", ""));
  }

  /**
   * Loads all other questionnaires, with a copy for each area if asked after each area; empty after
   * a fault.
   */
  Optional<List<Asked>> asked() throws IOException {
    List<Asked> asked = new ArrayList<>();
    boolean whole = true;
    for (Source source : study.questionnaires().list()) {
      Optional<List<Questionnaire>> read = read(source);
      whole &= read.isPresent();
      read.orElse(List.of()).forEach(each -> asked.add(new Asked(each, source.moment())));
    }
    return whole ? Optional.of(asked) : Optional.empty();
  }

  private Optional<Questionnaire> own(Path file) throws IOException {
    return QuestionnaireReader.read(
        file,
        new LocalizedTexts(study.language(), study.languages()),
        StudyPermissions.pictures(study, file),
        problems);
  }

  /** Loads a questionnaire of the program, which a study of several languages needs in each. */
  private Optional<Questionnaire> standard(String name) throws IOException {
    if (study.languages().size() > 1 && !StandardScales.has(name, study.language())) {
      problems.error(
          SourceLocation.of(study.file().toString()),
          ("the built-in questionnaire %s has no texts in the language '%s'; translate it in a"
                  + " \"file\" of the study. The study is not used")
              .formatted(name, study.language()));
      return Optional.empty();
    }
    return StandardScales.of(name, study.language(), problems);
  }

  private Optional<List<Questionnaire>> read(Source source) throws IOException {
    if (source.content() instanceof Content.Items items) {
      return ItemListReader.read(
          items.kind(),
          items.file(),
          source.name().orElse(items.kind().spelling()),
          KnownAreas.of(study),
          wording,
          problems);
    }
    Optional<Questionnaire> read =
        source.content() instanceof Content.Own own
            ? own(own.file())
            : standard(((Content.Standard) source.content()).template());
    return read.map(one -> one.as(source.name().orElse(one.name()), ""))
        .map(
            one ->
                source.moment() == Moment.AFTER_AREA
                    ? study.areas().stream()
                        .map(area -> one.about(area.name(), wording.area(area.name())))
                        .toList()
                    : List.of(one));
  }
}
