package org.selectiverenderer.experiment.window;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.time.LocalTime;
import java.time.temporal.ChronoUnit;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import org.selectiverenderer.experiment.session.OperatorControls;

/** The experimenter's controls: where the session is, go on, pause, abort, notes. */
public final class ControlWindow implements AutoCloseable {
  private final OperatorControls controls;
  private final JFrame frame = new JFrame("Session");
  private final JLabel status = new JLabel(" ");
  private final JTextArea notes = new JTextArea(8, 40);
  private final JTextField note = new JTextField();
  private final Timer refresh;
  private boolean asking;

  private ControlWindow(OperatorControls controls) {
    this.controls = controls;
    status.setName("status");
    status.setFont(status.getFont().deriveFont(18f));
    status.setBorder(BorderFactory.createEmptyBorder(12, 12, 4, 12));
    notes.setEditable(false);
    frame.setName("controls");
    frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(new ClosingAsks(this::abort));
    controls.questioner(() -> EventQueue.invokeLater(this::abort));
    frame.add(status, BorderLayout.NORTH);
    frame.add(new JScrollPane(notes), BorderLayout.CENTER);
    JPanel below = new JPanel(new BorderLayout());
    below.add(writing(), BorderLayout.NORTH);
    below.add(buttons(), BorderLayout.SOUTH);
    frame.add(below, BorderLayout.SOUTH);
    frame.pack();
    // In a corner, so that a single monitor shows it beside the participant's window.
    Rectangle most = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    frame.setLocation(
        most.x + most.width - frame.getWidth(), most.y + most.height - frame.getHeight());
    refresh = new Timer(200, event -> status.setText(controls.status() + " "));
    refresh.start();
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
    JButton go = new JButton("Go on");
    go.setName("go");
    go.getAccessibleContext().setAccessibleDescription("ends the practice");
    go.addActionListener(event -> controls.goOn());
    JToggleButton pause = new JToggleButton("Pause");
    pause.setName("pause");
    pause
        .getAccessibleContext()
        .setAccessibleDescription("stops the clock and blackens the participant's picture");
    pause.addActionListener(
        event -> {
          controls.pause(pause.isSelected());
          pause.setText(pause.isSelected() ? "Continue" : "Pause");
        });
    JButton abort = new JButton("Abort ...");
    abort.setName("abort");
    abort.addActionListener(event -> abort());
    JPanel line = new JPanel(new FlowLayout(FlowLayout.RIGHT));
    line.add(abort);
    line.add(pause);
    line.add(go);
    return line;
  }

  /** Opens it and goes on. */
  public static ControlWindow open(OperatorControls controls) {
    return Waiting.onSwing(
        () -> {
          ControlWindow window = new ControlWindow(controls);
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

  /** Asks once, however often windows are closed meanwhile. */
  private void abort() {
    if (asking) {
      return;
    }
    asking = true;
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
    if (answer == 0) {
      controls.abort();
    }
  }

  @Override
  public void close() {
    Waiting.onSwing(
        () -> {
          refresh.stop();
          frame.dispose();
          return frame;
        });
  }
}
