package org.selectiverenderer.experiment.window;

import java.awt.BorderLayout;
import java.awt.FlowLayout;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.WindowConstants;
import org.selectiverenderer.experiment.questionnaire.Wording;

/** Age and consent of a participant (thesis Appendix A and D, sections A and B). */
public final class FormWindow {
  private static final List<String> AGES =
      List.of("18-22", "23-27", "28-32", "33-37", "38-42", "43+");

  private final JFrame frame = new JFrame();
  private final ButtonGroup ages = new ButtonGroup();
  private final JCheckBox consent = new JCheckBox();
  private final JButton begin = new JButton();

  private FormWindow(
      String participant, Wording wording, SessionEnd end, Consumer<Optional<String>> answer) {
    JPanel fields = new JPanel();
    fields.setLayout(new BoxLayout(fields, BoxLayout.Y_AXIS));
    fields.setBorder(BorderFactory.createEmptyBorder(16, 16, 16, 16));
    JLabel id = new JLabel(wording.of("form.id") + ": " + participant);
    id.setFont(id.getFont().deriveFont(20f));
    id.setAlignmentX(0);
    fields.add(id);
    JPanel bands = new JPanel(new FlowLayout(FlowLayout.LEFT));
    bands.setAlignmentX(0);
    bands.add(new JLabel(wording.of("form.age") + ":"));
    for (String age : AGES) {
      JRadioButton button = new JRadioButton(age);
      button.setActionCommand(age);
      button.setName(age);
      button.addActionListener(event -> check());
      ages.add(button);
      bands.add(button);
    }
    fields.add(bands);
    consent.setText("<html><body style='width:380px'>" + wording.of("form.consent"));
    consent.setName("consent");
    consent.getAccessibleContext().setAccessibleName(wording.of("form.consent"));
    consent.setAlignmentX(0);
    consent.addActionListener(event -> check());
    fields.add(consent);
    begin.setText(wording.of("form.begin"));
    begin.setName("begin");
    begin.setEnabled(false);
    begin.addActionListener(
        event -> answer.accept(Optional.of(ages.getSelection().getActionCommand())));
    JButton cancel = new JButton(wording.of("form.cancel"));
    cancel.setName("cancel");
    cancel.addActionListener(event -> answer.accept(Optional.empty()));
    JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT));
    buttons.add(cancel);
    buttons.add(begin);
    frame.setName("form");
    frame.setTitle(wording.of("form.title"));
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    end.watch(frame, () -> answer.accept(Optional.empty()));
    frame.add(fields, BorderLayout.CENTER);
    frame.add(buttons, BorderLayout.SOUTH);
    frame.getRootPane().setDefaultButton(begin);
    frame.pack();
    frame.setLocationRelativeTo(null);
  }

  /**
   * Asks, and waits for the answer, or until the session ends.
   *
   * @return the age band; empty when the participant does not take part, or the session has ended
   */
  public static Optional<String> ask(String participant, Wording wording, SessionEnd end) {
    List<Optional<String>> answers = new CopyOnWriteArrayList<>();
    Waiting.on(
        done ->
            new FormWindow(
                    participant,
                    wording,
                    end,
                    answer -> {
                      answers.add(answer);
                      done.run();
                    })
                .frame);
    return answers.isEmpty() ? Optional.empty() : answers.get(0);
  }

  private void check() {
    begin.setEnabled(consent.isSelected() && ages.getSelection() != null);
  }
}
