package org.selectiverenderer.enricher.newscene;

import java.awt.Component;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiPredicate;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.creation.NewScene;
import org.selectiverenderer.authoring.creation.RoomSize;
import org.selectiverenderer.enricher.component.FileNameSelection;
import org.selectiverenderer.enricher.component.InitialFocus;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/** Asks what a new scene begins with, and which file it becomes. */
@SuppressWarnings("serial") // never written
public final class NewSceneDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final String ENDING = ".x3d";

  /**
   * A scene to be written.
   *
   * @param replace whether the author agreed to replace the file that is there
   */
  public record Answer(Path file, String text, boolean replace) {}

  private final JRadioButton room =
      Mnemonics.on(new JRadioButton("", true), Texts.of("create.room"));
  private final JRadioButton empty = Mnemonics.on(new JRadioButton(), Texts.of("create.empty"));
  private final JSpinner width = metres(RoomSize.USUAL.width());
  private final JSpinner depth = metres(RoomSize.USUAL.depth());
  private final JSpinner height = metres(RoomSize.USUAL.height());
  private final JCheckBox ceiling =
      Mnemonics.on(new JCheckBox("", true), Texts.of("create.ceiling"));
  private final JTextField file = new JTextField(36);
  private final JLabel wrong = PlainText.only(new JLabel(" "));
  private final JButton create = Mnemonics.button("create.create");
  private final BiPredicate<Window, String> overwrite;
  private @Nullable Answer answer;

  /**
   * @param proposed the file that is proposed; it need not exist
   * @param overwrite asks over a window whether a file may be overwritten, with a sentence
   */
  public NewSceneDialog(Window owner, Path proposed, BiPredicate<Window, String> overwrite) {
    super(owner, Texts.of("create.title"), ModalityType.DOCUMENT_MODAL);
    this.overwrite = overwrite;
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    ButtonGroup kinds = new ButtonGroup();
    kinds.add(room);
    kinds.add(empty);
    room.addActionListener(e -> enableSizes());
    empty.addActionListener(e -> enableSizes());
    file.setText(proposed.toString());
    JPanel content = new JPanel(new MigLayout("insets dialog, fillx, wrap 1", "[grow,fill]"));
    content.add(room);
    content.add(sizes(), "gapleft indent");
    content.add(empty);
    content.add(target(), "gaptop unrel");
    wrong.getAccessibleContext().setAccessibleName(Texts.of("create.wrong"));
    content.add(wrong, "wmin 0");
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    create.addActionListener(e -> confirm());
    cancel.addActionListener(e -> dispose());
    JPanel buttons = new JPanel(new MigLayout("insets 0", "push[sizegroup b][sizegroup b]"));
    buttons.add(create);
    buttons.add(cancel);
    content.add(buttons);
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    WindowPacker.pack(this);
    getRootPane().setDefaultButton(create); // after packing, which takes it away
    setLocationRelativeTo(owner);
  }

  private static JSpinner metres(double usual) {
    return new JSpinner(new SpinnerNumberModel(usual, RoomSize.LEAST, RoomSize.MOST, 0.5));
  }

  private JPanel sizes() {
    JPanel panel = new JPanel(new MigLayout("insets 0", "[][60::][]unrel[][60::]unrel[][60::]"));
    size(panel, "create.width", width);
    size(panel, "create.depth", depth);
    size(panel, "create.height", height);
    panel.add(ceiling, "newline, span");
    return panel;
  }

  private static void size(JPanel panel, String name, JSpinner spinner) {
    JLabel label = Mnemonics.label(name);
    label.setLabelFor(spinner);
    spinner.getAccessibleContext().setAccessibleName(label.getText());
    if (spinner.getEditor() instanceof JSpinner.DefaultEditor editor) {
      editor.getTextField().getAccessibleContext().setAccessibleName(label.getText());
    }
    for (Component arrow : spinner.getComponents()) {
      if (arrow instanceof JButton button) {
        boolean more = "Spinner.nextButton".equals(button.getName());
        button
            .getAccessibleContext()
            .setAccessibleName(Texts.of(more ? "create.more" : "create.less", label.getText()));
      }
    }
    panel.add(label);
    panel.add(spinner);
  }

  private JPanel target() {
    JPanel panel = new JPanel(new MigLayout("insets 0, fillx", "[][grow,fill][]"));
    JLabel label = Mnemonics.label("create.file");
    label.setLabelFor(file);
    file.getAccessibleContext().setAccessibleName(label.getText());
    JButton browse = Mnemonics.button("create.browse");
    browse.addActionListener(e -> browse());
    panel.add(label);
    panel.add(file);
    panel.add(browse);
    return panel;
  }

  private void enableSizes() {
    for (JComponent each : new JComponent[] {width, depth, height, ceiling}) {
      each.setEnabled(room.isSelected());
    }
  }

  private void browse() {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setDialogTitle(Texts.of("create.title"));
    typed().ifPresent(path -> chooser.setSelectedFile(path.toFile()));
    if (chooser.showDialog(this, Texts.of("create.choose")) == JFileChooser.APPROVE_OPTION) {
      file.setText(chooser.chosen().toString());
    }
  }

  /** Returns the file that is typed, with the ending of scenes; empty if it is none. */
  private Optional<Path> typed() {
    String name = file.getText().strip();
    try {
      Path path = Path.of(name).toAbsolutePath().normalize();
      if (name.isEmpty() || path.getFileName() == null) {
        return Optional.empty();
      }
      boolean named = path.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(ENDING);
      return Optional.of(named ? path : path.resolveSibling(path.getFileName() + ENDING));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private void confirm() {
    Optional<Path> target = typed();
    if (target.isEmpty()) {
      wrong.setText(Texts.of("create.nofile"));
    } else if (!Files.isDirectory(target.get().getParent())) {
      wrong.setText(Texts.of("create.nofolder", String.valueOf(target.get().getParent())));
    } else {
      boolean there = Files.exists(target.get());
      if (!there || overwrite.test(this, Texts.of("keep.exists", target.get().toString()))) {
        answer = new Answer(target.get(), text(String.valueOf(target.get().getFileName())), there);
        dispose();
      }
    }
  }

  private String text(String title) {
    return room.isSelected()
        ? NewScene.room(
            title, new RoomSize(number(width), number(depth), number(height)), ceiling.isSelected())
        : NewScene.empty(title);
  }

  private static double number(JSpinner spinner) {
    return spinner.getValue() instanceof Number number ? number.doubleValue() : RoomSize.LEAST;
  }

  /** Shows the dialog and waits; empty if the author cancels. */
  public Optional<Answer> ask() {
    FileNameSelection.select(file, ENDING);
    InitialFocus.show(this, file);
    return Optional.ofNullable(answer);
  }
}
