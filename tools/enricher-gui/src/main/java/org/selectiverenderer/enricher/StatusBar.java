package org.selectiverenderer.enricher;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.problems.ProblemCounts;
import org.selectiverenderer.enricher.problems.SeverityIcon;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;

/**
 * The status bar: the last message, the number of problems, and the progress of long tasks with a
 * Cancel button.
 */
final class StatusBar {
  private static final int EVERY_MILLISECONDS = 150;
  private static final long PATIENCE_NANOSECONDS = 500_000_000L;
  private static final int STEPS = 1000;

  private final TaskExecutor tasks;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 3 8 3 8, hidemode 3, fillx", "[grow][][][]", "[24!]"));
  private final JLabel message = PlainText.only(new JLabel(" "));
  private final JLabel problems = new JLabel();
  private final JProgressBar bar = new JProgressBar(0, STEPS);
  private final JButton cancel = new JButton(Texts.of("keep.cancel"));
  private String announced = "";
  private final Timer timer = new Timer(EVERY_MILLISECONDS, event -> refresh());

  StatusBar(TaskExecutor tasks) {
    this.tasks = tasks;
    message.getAccessibleContext().setAccessibleName(Texts.of("window.message"));
    bar.getAccessibleContext().setAccessibleName(Texts.of("window.progress"));
    cancel.addActionListener(event -> tasks.running().forEach(BackgroundTask::cancel));
    panel.add(message, "growx, wmin 0");
    panel.add(bar, "w 240!");
    panel.add(cancel);
    panel.add(problems, "gapbefore 12");
    refresh();
    timer.start();
  }

  JPanel component() {
    return panel;
  }

  void say(String sentence) {
    message.setText(sentence);
    message.setToolTipText(PlainText.of(sentence));
  }

  /** Sets the name of a task that is told of elsewhere, so that its progress is without it. */
  void announced(String task) {
    announced = task;
  }

  /** Shows how many problems there are. */
  void count(ProblemCounts counts) {
    problems.setText(counts.words());
    problems.setIcon(counts.worst().map(SeverityIcon::new).orElse(null));
    problems.getAccessibleContext().setAccessibleName(counts.words());
  }

  private void refresh() {
    long now = System.nanoTime();
    List<BackgroundTask> slow =
        tasks.running().stream().filter(task -> now - task.begun() > PATIENCE_NANOSECONDS).toList();
    bar.setVisible(!slow.isEmpty());
    cancel.setVisible(slow.stream().anyMatch(BackgroundTask::stoppable));
    if (!slow.isEmpty()) {
      BackgroundTask first = slow.get(0);
      bar.setStringPainted(slow.size() > 1 || !first.name().equals(announced));
      bar.setString(
          Texts.of("window.tasks", first.name(), slow.size() - 1, String.valueOf(slow.size() - 1)));
      bar.setIndeterminate(first.fraction() < 0);
      bar.setValue((int) (first.fraction() * STEPS));
    }
  }

  void dispose() {
    timer.stop();
  }
}
