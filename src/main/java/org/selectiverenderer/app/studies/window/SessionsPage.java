package org.selectiverenderer.app.studies.window;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.studies.ParticipantCheck;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.study.session.StudyStatus;
import org.selectiverenderer.swing.PlainText;

/** The sessions with what is missing and their flags, and the sizes of the groups. */
final class SessionsPage extends JPanel {
  private static final long serialVersionUID = 1;

  /** Resumes a session. */
  interface Resuming {
    void resume(String participant, int session);
  }

  private final transient StudyDesk desk;
  private final transient Resuming resuming;
  private final JLabel summary = PlainText.only(new JLabel(" "));
  private final JLabel empty = new JLabel();
  private final RowsModel rows =
      new RowsModel(
          "sessions.participant",
          "sessions.session",
          "sessions.condition",
          "sessions.state",
          "sessions.missing",
          "sessions.flags");
  private final RowsTable table = new RowsTable(rows, "sessions", 16, 12, 14, 16, 30, 30);
  private final RowsModel sizes =
      new RowsModel("sessions.group", "sessions.planned", "sessions.assigned", "sessions.finished");
  private final RowsTable groups = new RowsTable(sizes, "groups", 24, 10, 10, 10);
  private final JCheckBox showCondition = StudyTexts.checkBox("sessions.showcondition");
  private final JButton resume = StudyTexts.button("sessions.resume");
  private final ActionLine status;

  SessionsPage(StudyDesk desk, Resuming resuming) {
    super(
        new MigLayout(
            "insets 12, fill, wrap 1, hidemode 3",
            "[grow,fill]",
            "[][][grow 70,fill][][grow 30,fill][]"));
    this.desk = desk;
    this.resuming = resuming;
    status = new ActionLine("sessions.reload", desk::reload);
    summary.setName("sessions.summary");
    empty.setText(StudyTexts.of("sessions.none"));
    add(summary);
    add(showCondition);
    add(empty, "split 2, flowy");
    add(new JScrollPane(table), "grow, push, hmin 80");
    add(resume, "grow 0");
    add(new JScrollPane(groups), "grow, hmin 60, hmax 30%");
    add(status);
    showCondition.addActionListener(event -> show(desk.study()));
    table.getSelectionModel().addListSelectionListener(event -> select());
    resume.addActionListener(event -> resume());
    desk.listen(this::show);
  }

  private void show(Optional<StudyOverview> study) {
    if (study.isEmpty()) {
      rows.rows(List.of());
      sizes.rows(List.of());
      summary.setText(" ");
      showCondition.setSelected(false);
      status.command(Optional.empty());
      select();
      return;
    }
    StudyOverview known = study.get();
    showCondition.setVisible(known.blind());
    StudyStatus shown = known.status(showCondition.isSelected());
    int chosen = table.getSelectedRow();
    rows.rows(shown.sessions().stream().map(row -> row(known, row)).toList());
    if (chosen >= 0 && chosen < table.getRowCount()) {
      table.setRowSelectionInterval(chosen, chosen);
    }
    sizes.rows(shown.groups().stream().map(SessionsPage::row).toList());
    empty.setVisible(shown.sessions().isEmpty());
    int finished = shown.groups().stream().mapToInt(StudyStatus.Group::finished).sum();
    int counting = shown.groups().stream().mapToInt(StudyStatus.Group::counting).sum();
    summary.setText(
        StudyTexts.of(
                "sessions.summary", Integer.toString(finished), Integer.toString(shown.planned()))
            + (finished == counting
                ? ""
                : " " + StudyTexts.of("sessions.out", Integer.toString(finished - counting))));
    status.command(desk.commands().map(commands -> commands.status(showCondition.isSelected())));
    select();
  }

  private static List<String> row(StudyOverview known, StudyStatus.Row row) {
    boolean runs = known.running(row.participant(), row.session());
    String flags = row.raised().stream().map(LiveSession::flag).collect(Collectors.joining(", "));
    return List.of(
        row.participant(),
        Integer.toString(row.session()),
        row.condition().equals("hidden") && known.blind()
            ? StudyTexts.of("hidden")
            : row.condition().isEmpty() ? "\u2013" : row.condition(),
        StudyTexts.of(
            runs ? "state.running" : "state." + row.state().name().toLowerCase(Locale.ROOT)),
        String.join(", ", row.missing()),
        (row.excluded() ? StudyTexts.of("sessions.excluded") + " " : "") + flags);
  }

  private static List<String> row(StudyStatus.Group group) {
    return List.of(
        group.condition(),
        Integer.toString(group.planned()),
        Integer.toString(group.assigned()),
        Integer.toString(group.finished()));
  }

  private Optional<StudyStatus.Row> selected() {
    int row = table.getSelectedRow();
    return desk.study()
        .map(known -> known.status().sessions())
        .filter(sessions -> row >= 0 && row < sessions.size())
        .map(sessions -> sessions.get(row));
  }

  private void select() {
    resume.setEnabled(
        selected()
            .filter(row -> ParticipantCheck.resumable(row.state()))
            .filter(
                row ->
                    desk.study()
                        .filter(known -> !known.running(row.participant(), row.session()))
                        .isPresent())
            .isPresent());
  }

  private void resume() {
    selected().ifPresent(row -> resuming.resume(row.participant(), row.session()));
  }
}
