package org.selectiverenderer.enricher.versions;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PictureReducer;

/**
 * Makes levels of texture and shading of an object, as the command {@code versions} does with
 * {@code --texture-percent} and {@code --shading}: smaller pictures beside those of the scene, and
 * the levels in the scene, as one undo step. For the event dispatch thread.
 */
public final class QualityLevelsMaker {
  private final EnricherSession session;

  /** Makes levels in the document of a session. */
  public QualityLevelsMaker(EnricherSession session) {
    this.session = session;
  }

  /**
   * Asks for the levels and makes them.
   *
   * @param object the DEF name of the object, or of its Switch
   */
  public void ask(Component over, String object) {
    Optional<EnrichedSwitch> node =
        Optional.ofNullable(session.enrichment().switchesByName().get(object));
    QualityLevelsPanel panel =
        new QualityLevelsPanel(node.map(EnrichedSwitch::fields).orElse(List.of()));
    boolean wanted =
        new InputDialog(over, Texts.of("versions.levels"), panel, panel.first())
            .ask(panel::complaint);
    if (wanted) {
      make(panel.request(object));
    }
  }

  /** What was planned, and the problems found. */
  private record Planned(Optional<QualityVersionsEdit.Plan> plan, List<Problem> problems) {}

  /** Plans in the background, then writes files and scene as one step. */
  void make(QualityVersionsEdit.Request request) {
    SceneDocument document = session.document();
    long revision = document.revision();
    ProblemCollector problems = new ProblemCollector();
    QualityVersionsEdit edit;
    try {
      Path scene = session.file().path();
      edit =
          new QualityVersionsEdit(document, session.catalogue(), scene, session.access(), problems);
    } catch (IOException e) {
      session.message(Remarks.of(e));
      return;
    }
    session
        .tasks()
        .run(
            Texts.of("versions.levels.making"),
            progress -> new Planned(edit.plan(request, PictureReducer::reduced), problems.list()),
            planned -> apply(request.object(), revision, planned),
            failed -> session.message(Remarks.of(failed)));
  }

  /** Returns the message about a problem after its place; an error concerns the whole object. */
  private static String said(Problem problem) {
    SourceLocation at = problem.location();
    return problem.severity() == Problem.Severity.ERROR
        ? problem.message()
        : new SourceLocation(at.file().replaceFirst(".*[/\\\\]", ""), at.line(), at.column())
            + ": "
            + problem.message();
  }

  private void apply(String object, long revision, Planned planned) {
    Optional<Problem> first = planned.problems().stream().findFirst(); // the cause of later ones
    if (planned.plan().isEmpty()) {
      first.ifPresent(problem -> session.message(said(problem)));
      return;
    }
    if (session.document().revision() != revision) {
      session.message(Texts.of("versions.levels.outdated", object));
      return;
    }
    QualityVersionsEdit.Plan plan = planned.plan().get();
    try {
      session
          .document()
          .perform(
              plan.edit(),
              plan.files().stream()
                  .filter(file -> file.state() != PlannedFile.State.UNCHANGED)
                  .map(file -> new UndoableFileWrite(file.file(), file.content(), file.byHand()))
                  .toList());
      List<String> pictures = written(plan);
      session.message(
          first
              .map(QualityLevelsMaker::said)
              .orElseGet(
                  () ->
                      Texts.of(
                          "versions.levels.made",
                          plan.object(),
                          pictures.size(),
                          String.join(", ", pictures))));
    } catch (EditRejectedException | IOException e) {
      session.message(Remarks.of(e));
    }
  }

  /** Returns the names of the pictures that a plan writes, sorted. */
  private static List<String> written(QualityVersionsEdit.Plan plan) {
    return plan.files().stream()
        .filter(file -> file.state() != PlannedFile.State.UNCHANGED)
        .map(file -> String.valueOf(file.file().getFileName()))
        .sorted()
        .toList();
  }
}
