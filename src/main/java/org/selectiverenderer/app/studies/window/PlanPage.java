package org.selectiverenderer.app.studies.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.studies.StudyOverview;
import org.selectiverenderer.study.session.StudyPlan;

/** The plan: place, participant, group and order; groups of a blind study only if asked for. */
final class PlanPage extends JPanel {
  private static final long serialVersionUID = 1;

  /** Number of combinations of a block that a row names; the page shows all trials. */
  private static final int MOST_RUNS = 40;

  private final transient StudyDesk desk;
  private final RowsModel rows =
      new RowsModel("plan.place", "plan.participant", "plan.group", "plan.order");
  private final RowsTable table = new RowsTable(rows, "plan", 7, 16, 16, 80);
  private final JCheckBox showCondition = StudyTexts.checkBox("plan.showcondition");
  private final ActionLine page = new ActionLine("plan.page", this::page);
  private final JLabel note = new JLabel(" ");

  PlanPage(StudyDesk desk) {
    super(new MigLayout("insets 12, fill, wrap 1, hidemode 3", "[grow,fill]", "[][][grow,fill][]"));
    this.desk = desk;
    note.setName("plan.note");
    add(note);
    add(showCondition);
    add(new JScrollPane(table), "grow, push, hmin 60");
    add(page);
    showCondition.addActionListener(event -> show(desk.study()));
    desk.listen(this::show);
  }

  private void show(Optional<StudyOverview> study) {
    if (study.isEmpty()) {
      rows.rows(List.of());
      page.command(Optional.empty());
      showCondition.setSelected(false);
      return;
    }
    StudyOverview known = study.get();
    boolean hidden = known.blind() && !showCondition.isSelected();
    showCondition.setVisible(known.blind());
    StudyPlan plan = known.plan();
    rows.rows(plan.places().stream().map(place -> row(place, hidden)).toList());
    table.bold(row -> plan.places().get(row).number() == plan.next());
    note.setText(
        plan.faults().isEmpty()
            ? StudyTexts.of(hidden ? "plan.next.blind" : "plan.next", Integer.toString(plan.next()))
            : StudyTexts.of("plan.fault", plan.faults().get(0)));
    page.command(
        hidden
            ? Optional.empty()
            : desk.commands().map(commands -> commands.planPage(file(known))));
  }

  private static Path file(StudyOverview known) {
    return Path.of(System.getProperty("java.io.tmpdir"))
        .resolve("selective-renderer-plan")
        .resolve(known.study().folder().toAbsolutePath().normalize().getFileName() + ".html");
  }

  private static List<String> row(StudyPlan.Place place, boolean hidden) {
    return List.of(
        Integer.toString(place.number()),
        place.participant().orElse("\u2013"),
        hidden ? StudyTexts.of("hidden") : place.group().name(),
        place.blocks().stream().map(PlanPage::order).collect(Collectors.joining("; ")));
  }

  private static String order(StudyPlan.Block block) {
    if (block.trials().isEmpty()) {
      return block.name() + ": " + block.open().orElse(StudyTexts.of("plan.noorder"));
    }
    return block.name()
        + ": "
        + String.join(
            ", ", runs(block.trials().stream().map(StudyPlan.PlannedTrial::combination).toList()));
  }

  /** Returns neighbours that are equal as one with their number; after the most of them dots. */
  static List<String> runs(List<String> trials) {
    List<String> runs = new ArrayList<>();
    int i = 0;
    while (i < trials.size() && runs.size() < MOST_RUNS) {
      int from = i;
      while (i < trials.size() && trials.get(i).equals(trials.get(from))) {
        i++;
      }
      runs.add(i - from == 1 ? trials.get(from) : i - from + " \u00d7 " + trials.get(from));
    }
    if (i < trials.size()) {
      runs.add("\u2026");
    }
    return runs;
  }

  private void page() {
    Optional<StudyOverview> study = desk.study();
    if (study.isEmpty()) {
      return;
    }
    Path file = file(study.get());
    page.allow(false);
    desk.reader()
        .read(
            () -> {
              Path folder = file.toAbsolutePath().getParent();
              Files.createDirectories(folder);
              if (Files.isSymbolicLink(folder)) {
                throw new IOException(StudyTexts.of("link", folder.toString()));
              }
              return file;
            },
            ready ->
                desk.commands()
                    .ifPresent(
                        commands ->
                            desk.run(
                                commands.planPage(file),
                                () -> {
                                  page.allow(true);
                                  desk.browse(file);
                                },
                                () -> page.allow(true))),
            why -> {
              page.allow(true);
              desk.say(why);
            });
  }
}
