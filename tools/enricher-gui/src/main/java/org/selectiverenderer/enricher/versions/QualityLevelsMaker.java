package org.selectiverenderer.enricher.versions;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
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
    JTextField percents = new JTextField("50, 25", 14);
    percents.setName("Percents");
    percents.getAccessibleContext().setAccessibleName(Texts.of("versions.levels.percents"));
    JLabel label = Mnemonics.label("versions.levels.percents");
    label.setLabelFor(percents);
    JCheckBox vertex = Mnemonics.on(new JCheckBox(), Texts.of("versions.levels.vertex"));
    JCheckBox flat = Mnemonics.on(new JCheckBox(), Texts.of("versions.levels.flat"));
    JPanel panel = new JPanel(new MigLayout("insets 0, wrap 2", "[][grow,fill]"));
    panel.add(label);
    panel.add(percents);
    panel.add(new JLabel(Texts.of("versions.levels.shading")));
    JPanel boxes = new JPanel(new MigLayout("insets 0"));
    boxes.add(vertex);
    boxes.add(flat);
    panel.add(boxes);
    panel.add(new JLabel(Texts.of("versions.levels.note")), "span");
    boolean wanted =
        new InputDialog(over, Texts.of("versions.levels"), panel, percents)
            .ask(() -> complaint(percents.getText(), vertex.isSelected() || flat.isSelected()));
    if (wanted) {
      List<String> shading = new ArrayList<>();
      if (vertex.isSelected()) {
        shading.add("vertex");
      }
      if (flat.isSelected()) {
        shading.add("flat");
      }
      make(
          new QualityVersionsEdit.Request(
              object, percents(percents.getText()).orElseThrow(), shading, List.of()));
    }
  }

  private static Optional<String> complaint(String text, boolean shading) {
    Optional<List<Double>> percents = percents(text);
    if (percents.isEmpty()) {
      return Optional.of(
          Texts.of("versions.levels.falling", String.valueOf(VersionsModel.MOST)));
    }
    return percents.get().isEmpty() && !shading
        ? Optional.of(Texts.of("versions.levels.none"))
        : Optional.empty();
  }

  /** Returns a few falling numbers between 100 and 0, with commas; empty for anything else. */
  static Optional<List<Double>> percents(String text) {
    List<Double> percents = new ArrayList<>();
    double before = 100;
    for (String word : Stream.of(text.split("[,;\\s%]+")).filter(w -> !w.isEmpty()).toList()) {
      try {
        double percent = Double.parseDouble(word);
        if (!(percent > 0 && percent < before)) {
          return Optional.empty();
        }
        before = percent;
        percents.add(percent);
      } catch (NumberFormatException e) {
        return Optional.empty();
      }
    }
    return percents.size() > VersionsModel.MOST ? Optional.empty() : Optional.of(percents);
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

  /** Returns what is said of a problem: its place but of one with the whole object. */
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
      session.message(
          first
              .map(QualityLevelsMaker::said)
              .orElseGet(
                  () ->
                      Texts.of(
                          "versions.levels.made",
                          plan.object(),
                          plan.files().size(),
                          pictures(plan))));
    } catch (EditRejectedException | IOException e) {
      session.message(Remarks.of(e));
    }
  }

  /** The names of the pictures of a plan. */
  private static String pictures(QualityVersionsEdit.Plan plan) {
    return plan.files().stream()
        .map(file -> String.valueOf(file.file().getFileName()))
        .sorted()
        .collect(Collectors.joining(", "));
  }
}
