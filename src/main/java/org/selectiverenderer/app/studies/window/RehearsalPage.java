package org.selectiverenderer.app.studies.window;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTextArea;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.rehearsal.StudyCheck;
import org.selectiverenderer.app.rehearsal.StudyCheckReport;
import org.selectiverenderer.app.studies.StudyCommands;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.SessionStep;
import org.selectiverenderer.swing.PlainText;

/** The check of the study, and its preview as a page and as a session apart from the data. */
final class RehearsalPage extends JPanel {
  private static final long serialVersionUID = 1;
  private static final int FASTEST = 1_000;
  private static final int USUAL = 10;

  private final transient StudyDesk desk;
  private final JLabel verdict = PlainText.only(new JLabel(" "));
  private final RowsModel rows = new RowsModel("check.severity", "check.where", "check.what");
  private final RowsTable table = new RowsTable(rows, "findings", 10, 28, 80);
  private final JTextArea report = new JTextArea(8, 40);
  private final ActionLine check = new ActionLine("check.run", this::check);
  private final ActionLine page = new ActionLine("preview.page", this::page);
  private final JComboBox<String> from = PlainText.entries(new JComboBox<>());
  private final JSpinner speed = new JSpinner(new SpinnerNumberModel(USUAL, 1, FASTEST, 1));
  private final ActionLine session = new ActionLine("preview.session", this::session);
  private transient Optional<LoadedStudy> shown = Optional.empty();

  RehearsalPage(StudyDesk desk) {
    super(
        new MigLayout(
            "insets 12, fill, wrap 1",
            "[grow,fill]",
            "[][][grow 60,fill][grow 40,fill]unrel[][][]"));
    this.desk = desk;
    verdict.setName("check.verdict");
    report.setName("check.report");
    report.setEditable(false);
    report.setLineWrap(true);
    report.setWrapStyleWord(true);
    report.getAccessibleContext().setAccessibleName(StudyTexts.of("check.report"));
    from.setName("preview.from");
    speed.setName("preview.speed");
    add(check);
    add(verdict);
    add(new JScrollPane(table), "grow, push, hmin 60");
    add(new JScrollPane(report), "grow, push, hmin 100");
    add(page);
    JPanel choice = new JPanel(new MigLayout("insets 0, fillx", "[][][][][grow]"));
    JLabel step = StudyTexts.label("preview.step");
    step.setLabelFor(from);
    JLabel times = StudyTexts.label("preview.times");
    times.setLabelFor(((JSpinner.DefaultEditor) speed.getEditor()).getTextField());
    choice.add(step);
    choice.add(from);
    choice.add(speed, "gapleft 12");
    choice.add(times);
    add(choice);
    add(session);
    from.addActionListener(event -> commands());
    speed.addChangeListener(event -> commands());
    desk.listen(this::show);
  }

  private void show(Optional<StudyOverview> study) {
    Optional<LoadedStudy> now = study.map(StudyOverview::material);
    if (!now.equals(shown)) {
      shown = now;
      rows.rows(List.of());
      report.setText("");
      verdict.setText(StudyTexts.of("check.notyet"));
      from.removeAllItems();
      now.stream()
          .flatMap(material -> material.steps().stream())
          .map(SessionStep::id)
          .forEach(from::addItem);
      commands();
    }
  }

  private void commands() {
    Optional<StudyCommands> commands = desk.commands();
    check.command(commands.map(StudyCommands::check));
    page.command(commands.map(each -> each.preview(folder())));
    Object step = from.getSelectedItem();
    session.command(
        step == null
            ? Optional.empty()
            : commands.map(each -> each.previewFrom(step.toString(), (Integer) speed.getValue())));
  }

  /** Returns the folder of the preview's page, in that of temporary files: it is no data. */
  private Path folder() {
    String study =
        shown
            .map(known -> String.valueOf(known.study().folder().toAbsolutePath().getFileName()))
            .orElse("study");
    return Path.of(System.getProperty("java.io.tmpdir"))
        .resolve("selective-renderer-preview-" + study);
  }

  private void check() {
    Optional<LoadedStudy> material = shown;
    if (material.isEmpty()) {
      return;
    }
    check.allow(false);
    verdict.setText(StudyTexts.of("check.running.now"));
    desk.reader()
        .read(
            () -> {
              ProblemCollector problems = new ProblemCollector();
              // Read anew, as the author may have changed the file meanwhile.
              Optional<LoadedStudy> fresh =
                  LoadedStudy.read(
                      material.get().study().file(), Optional.empty(), study -> true, problems);
              return new Read(
                  fresh.isEmpty()
                      ? Optional.empty()
                      : Optional.of(StudyCheck.of(fresh.get(), problems)),
                  problems.list());
            },
            this::checked,
            why -> {
              check.allow(true);
              verdict.setText(" ");
              desk.say(why);
            });
  }

  private record Read(Optional<StudyCheck> check, List<Problem> found) {}

  private void checked(Read read) {
    check.allow(true);
    rows.rows(read.found().stream().map(RehearsalPage::row).toList());
    report.setText(read.check().map(done -> StudyCheckReport.text(done, read.found())).orElse(""));
    report.setCaretPosition(0);
    long count =
        read.found().stream()
            .filter(problem -> problem.severity() != Problem.Severity.INFO)
            .count();
    verdict.setText(
        count == 0
            ? StudyTexts.of("check.sound")
            : StudyTexts.of("check.findings", count, Long.toString(count)));
  }

  private static List<String> row(Problem problem) {
    String file = problem.location().file();
    int slash = Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\'));
    return List.of(
        StudyTexts.of("severity." + problem.severity().name().toLowerCase(Locale.ROOT)),
        file.substring(slash + 1)
            + (problem.location().line() > 0 ? ":" + problem.location().line() : ""),
        problem.message());
  }

  private void page() {
    Path folder = folder();
    page.allow(false);
    desk.commands()
        .ifPresent(
            commands ->
                desk.run(
                    commands.preview(folder),
                    () -> {
                      page.allow(true);
                      desk.browse(folder.resolve(StudyCommands.PREVIEW));
                    },
                    () -> page.allow(true)));
  }

  private void session() {
    Object step = from.getSelectedItem();
    if (step == null) {
      return;
    }
    session.allow(false);
    desk.commands()
        .ifPresent(
            commands ->
                desk.start(
                    commands.previewFrom(step.toString(), (Integer) speed.getValue()),
                    desk::say,
                    status -> session.allow(true),
                    process -> {}));
  }
}
