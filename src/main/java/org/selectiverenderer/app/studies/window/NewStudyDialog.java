package org.selectiverenderer.app.studies.window;

import java.awt.Frame;
import java.awt.event.KeyEvent;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.app.process.ProgramCommand;
import org.selectiverenderer.app.studies.StudyCommands;
import org.selectiverenderer.swing.PlainText;

/** Asks for the design, the folder and the scene of a new study, and makes it by the command. */
final class NewStudyDialog {
  /** The examples that {@code experiment new --design} copies. */
  private static final List<String> DESIGNS =
      List.of("change-blindness", "quality-and-light", "rooms-between", "levels-of-detail", "web");

  private final StudyDesk desk;
  private final JDialog dialog;
  private final JTextField folder = new JTextField(36);
  private final JComboBox<String> design = PlainText.only(new JComboBox<>());
  private final JTextField scene = new JTextField(36);
  private final JTextArea fault = new JTextArea(2, 36);
  private final ActionLine create = new ActionLine("new.create", this::create);
  private final Consumer<Path> made;

  /**
   * @param made receives the folder of the new study
   */
  NewStudyDialog(Frame owner, StudyDesk desk, Consumer<Path> made) {
    this.desk = desk;
    this.made = made;
    dialog = new JDialog(owner, StudyTexts.of("new.title"), true);
    dialog.setName("new");
    folder.setName("new.folder");
    scene.setName("new.scene");
    fault.setName("new.fault");
    fault.setEditable(false);
    fault.setLineWrap(true);
    fault.setWrapStyleWord(true);
    fault.setOpaque(false);
    JPanel panel = new JPanel(new MigLayout("insets 16, fillx, wrap 3", "[][grow,fill][]", ""));
    panel.add(new JLabel(StudyTexts.of("new.about")), "span 3, wrap");
    JLabel kind = StudyTexts.label("new.design");
    kind.setLabelFor(design);
    design.setName("new.design");
    design.addItem(StudyTexts.of("new.design.thesis"));
    DESIGNS.forEach(each -> design.addItem(StudyTexts.of("new.design." + each)));
    design.addActionListener(
        event -> {
          scene.setEnabled(example().isEmpty());
          commands();
        });
    panel.add(kind);
    panel.add(design, "span 2");
    row(panel, "new.folder", folder, JFileChooser.DIRECTORIES_ONLY);
    row(panel, "new.scene", scene, JFileChooser.FILES_ONLY);
    panel.add(create, "span 3, growx");
    panel.add(fault, "span 2, growx, wmin 0");
    JButton cancel = StudyTexts.button("cancel");
    cancel.addActionListener(event -> dialog.dispose());
    panel.add(cancel, "right");
    folder.addCaretListener(event -> commands());
    scene.addCaretListener(event -> commands());
    commands();
    dialog.setContentPane(panel);
    dialog.getRootPane().setDefaultButton(create.button());
    dialog
        .getRootPane()
        .registerKeyboardAction(
            event -> dialog.dispose(),
            KeyStroke.getKeyStroke(KeyEvent.VK_ESCAPE, 0),
            JComponent.WHEN_IN_FOCUSED_WINDOW);
    dialog.pack();
    dialog.setLocationRelativeTo(owner);
  }

  private void row(JPanel panel, String key, JTextField field, int mode) {
    JLabel label = StudyTexts.label(key);
    label.setLabelFor(field);
    JButton choose = StudyTexts.button(key + ".choose");
    choose.addActionListener(
        event -> {
          JFileChooser chooser = new JFileChooser(field.getText().strip());
          chooser.setFileSelectionMode(mode);
          if (chooser.showDialog(dialog, StudyTexts.of("choose")) == JFileChooser.APPROVE_OPTION) {
            field.setText(chooser.getSelectedFile().toString());
          }
        });
    panel.add(label);
    panel.add(field);
    panel.add(choose);
  }

  /** Shows the dialog until it is closed. */
  void show() {
    dialog.setVisible(true);
  }

  /** Returns the example to copy; empty for the study of the thesis. */
  private Optional<String> example() {
    int at = design.getSelectedIndex();
    return at <= 0 ? Optional.empty() : Optional.of(DESIGNS.get(at - 1));
  }

  private Optional<ProgramCommand> command() {
    String named = folder.getText().strip();
    String shown = scene.getText().strip();
    if (named.isEmpty()) {
      return Optional.empty();
    }
    try {
      if (example().isPresent()) {
        return Optional.of(StudyCommands.copy(Path.of(named), example().get()));
      }
      return Optional.of(
          StudyCommands.create(
              Path.of(named), shown.isEmpty() ? Optional.empty() : Optional.of(Path.of(shown))));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private void commands() {
    create.command(command());
  }

  private void create() {
    Optional<ProgramCommand> command = command();
    if (command.isEmpty()) {
      return;
    }
    Path place = Path.of(folder.getText().strip());
    create.allow(false);
    fault.setText("");
    StringBuilder told = new StringBuilder();
    desk.start(
        command.get(),
        line -> told.append(line).append('\n'),
        status -> {
          create.allow(true);
          if (status == 0) {
            dialog.dispose();
            made.accept(place);
          } else {
            fault.setText(told.toString().strip());
            dialog.pack();
          }
        },
        process -> {});
  }
}
