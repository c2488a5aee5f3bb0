package org.selectiverenderer.app.window;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.time.LocalTime;
import java.time.temporal.ChronoUnit;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import org.selectiverenderer.study.session.ExperimenterControls;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/**
 * The experimenter's control window: state of the session, go on, pause, reset of the heading,
 * abort and notes. The keys F4, F8 and F9 have the same functions as in the operator's other
 * windows.
 */
public final class ControlWindow implements AutoCloseable {
  private static final int ALARM_WIDTH = 440;
  private static final String HOW_TO_GO_ON =
      "F8 pauses, and continues when its records arrive again: look after its cable, its power or"
          + " its program. If it stays silent, F9 goes on from a practice, an exposure ends by its"
          + " time, and Abort ends the session; --resume --without-tracker then continues it.";

  private final ExperimenterControls controls;
  private final JFrame frame;
  private final JLabel status = PlainText.only(new JLabel(" "));
  private final JTextArea alarm = WrappedTextArea.of("\n" + HOW_TO_GO_ON, 15f, ALARM_WIDTH);
  private final JTextArea notes = new JTextArea(8, 40);
  private final JTextField note = new JTextField();
  private final JToggleButton pause = new JToggleButton("Pause (F8)");
  private final Timer refresh;
  private boolean asking;

  private ControlWindow(ExperimenterControls controls, MonitorBounds desk) {
    this.controls = controls;
    frame = new JFrame("Session", desk.configuration());
    status.setName("status");
    status.setFont(status.getFont().deriveFont(18f));
    status.setBorder(BorderFactory.createEmptyBorder(12, 12, 4, 12));
    notes.setEditable(false);
    frame.setName("controls");
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(new CloseInterceptor(this::abort));
    controls.questioner(() -> EventQueue.invokeLater(this::abort));
    frame.add(status, BorderLayout.NORTH);
    alarm.setName("alarm");
    alarm.setOpaque(true);
    alarm.setBackground(new Color(0xffe0b0));
    alarm.setBorder(BorderFactory.createEmptyBorder(4, 12, 4, 12));
    alarm.setVisible(false);
    JPanel middle = new JPanel(new BorderLayout());
    middle.add(alarm, BorderLayout.NORTH);
    middle.add(new JScrollPane(notes), BorderLayout.CENTER);
    frame.add(middle, BorderLayout.CENTER);
    JPanel below = new JPanel(new BorderLayout());
    below.add(writing(), BorderLayout.NORTH);
    below.add(buttons(), BorderLayout.SOUTH);
    frame.add(below, BorderLayout.SOUTH);
    WindowPacker.pack(frame);
    // In a corner, so that a single monitor shows it beside the participant's window.
    Rectangle most = desk.area();
    frame.setLocation(
        most.x + most.width - frame.getWidth(), most.y + most.height - frame.getHeight());
    key(KeyEvent.VK_F4, controls::resetHeading);
    key(KeyEvent.VK_F6, controls::calibrated);
    key(KeyEvent.VK_F8, () -> controls.pause(!controls.paused()));
    key(KeyEvent.VK_F9, controls::goOn);
    refresh = new Timer(200, event -> refresh());
    refresh.start();
  }

  /** Updates the state of the session, which a key in another window may also have paused. */
  private void refresh() {
    status.setText(controls.status() + " ");
    String wrong = controls.alarm();
    if (alarm.isVisible() == wrong.isEmpty()) {
      alarm.setVisible(!wrong.isEmpty());
      frame.revalidate(); // The notes give it room.
    }
    if (!wrong.isEmpty()) {
      alarm.setText(wrong + ".\n" + HOW_TO_GO_ON);
    }
    if (pause.isSelected() != controls.paused()) {
      pause.setSelected(controls.paused());
    }
    pause.setText((controls.paused() ? "Continue" : "Pause") + " (F8)");
  }

  private void key(int code, Runnable does) {
    KeyStroke stroke = KeyStroke.getKeyStroke(code, 0);
    frame.getRootPane().getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(stroke, stroke);
    frame
        .getRootPane()
        .getActionMap()
        .put(
            stroke,
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                does.run();
              }
            });
  }

  private JPanel writing() {
    note.setName("note");
    note.getAccessibleContext().setAccessibleName("Note to keep");
    JButton keep = new JButton("Note");
    keep.setName("keep");
    keep.addActionListener(event -> keepNote());
    note.addActionListener(event -> keepNote());
    JPanel line = new JPanel(new BorderLayout(8, 0));
    line.setBorder(BorderFactory.createEmptyBorder(8, 12, 0, 12));
    line.add(note, BorderLayout.CENTER);
    line.add(keep, BorderLayout.EAST);
    return line;
  }

  private JPanel buttons() {
    // No tool tips: in the corner of the screen they would lie over the buttons and take the click.
    JButton go = new JButton("Go on (F9)");
    go.setName("go");
    go.getAccessibleContext().setAccessibleDescription("ends the practice");
    go.addActionListener(event -> controls.goOn());
    pause.setName("pause");
    pause
        .getAccessibleContext()
        .setAccessibleDescription("stops the clock and blackens the participant's picture");
    pause.addActionListener(
        event -> {
          controls.pause(pause.isSelected());
          refresh();
        });
    JButton heading = new JButton("Reset Heading (F4)");
    heading.setName("heading");
    heading
        .getAccessibleContext()
        .setAccessibleDescription("makes where the head looks now straight ahead");
    heading.addActionListener(event -> controls.resetHeading());
    JButton abort = new JButton("Abort ...");
    abort.setName("abort");
    abort.addActionListener(event -> abort());
    JPanel line = new JPanel(new FlowLayout(FlowLayout.RIGHT));
    line.add(abort);
    if (controls.calibrates()) {
      JButton calibrated = new JButton("Calibrated (F6)");
      calibrated.setName("calibrated");
      calibrated
          .getAccessibleContext()
          .setAccessibleDescription("marks that the eye tracker has been calibrated");
      calibrated.addActionListener(event -> controls.calibrated());
      line.add(calibrated);
    }
    line.add(heading);
    line.add(pause);
    line.add(go);
    return line;
  }

  /**
   * Opens the window without waiting for it to close.
   *
   * @param desk the operator's monitor
   */
  public static ControlWindow open(ExperimenterControls controls, MonitorBounds desk) {
    return ModalWindowRunner.onSwing(
        () -> {
          ControlWindow window = new ControlWindow(controls, desk);
          window.frame.setVisible(true);
          return window;
        });
  }

  private void keepNote() {
    String text = note.getText().strip();
    if (!text.isEmpty()) {
      controls.note(text);
      notes.append(LocalTime.now().truncatedTo(ChronoUnit.SECONDS) + "  " + text + "\n");
      note.setText("");
    }
  }

  /** Asks whether to end the session; shows one dialog only, however often windows are closed. */
  private void abort() {
    if (asking) {
      return;
    }
    asking = true;
    controls.asking(true);
    if (frame.getExtendedState() == Frame.ICONIFIED) {
      frame.setExtendedState(Frame.NORMAL);
    }
    frame.toFront();
    Object[] answers = {"End the Session", "Continue the Session"};
    int answer =
        JOptionPane.showOptionDialog(
            frame,
            "End this session? Finished steps are kept, and --resume continues the session.",
            "Abort",
            JOptionPane.DEFAULT_OPTION,
            JOptionPane.WARNING_MESSAGE,
            null,
            answers,
            answers[1]);
    asking = false;
    controls.asking(false);
    if (answer == 0) {
      controls.abort();
    }
  }

  @Override
  public void close() {
    ModalWindowRunner.onSwing(
        () -> {
          refresh.stop();
          frame.dispose();
          return frame;
        });
  }
}
