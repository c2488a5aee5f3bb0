package org.selectiverenderer.enricher.importing;

import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.component.FileNameSelection;
import org.selectiverenderer.enricher.component.InitialFocus;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/** Asks for the folder or the archive that a scene is packaged into. */
@SuppressWarnings("serial") // never written
public final class PackageDialog extends JDialog {
  private static final long serialVersionUID = 1L;
  private static final String ENDING = ".zip";

  /**
   * Where the scene goes.
   *
   * @param zip whether it is an archive, else a folder
   */
  public record Target(Path path, boolean zip) {}

  private final JRadioButton zip =
      Mnemonics.on(new JRadioButton("", true), Texts.of("package.zip"));
  private final JRadioButton folder = Mnemonics.on(new JRadioButton(), Texts.of("package.folder"));
  private final JTextField path = new JTextField(36);
  private final JLabel wrong = PlainText.only(new JLabel(" "));
  private @Nullable Target target;

  /**
   * @param scene the scene's file, which the proposed target is beside
   */
  public PackageDialog(Window owner, Path scene) {
    super(owner, Texts.of("package.title"), ModalityType.DOCUMENT_MODAL);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    String name = String.valueOf(scene.getFileName());
    int dot = name.indexOf('.', 1);
    String stem = (dot < 0 ? name : name.substring(0, dot)) + "-package";
    path.setText(scene.toAbsolutePath().resolveSibling(stem + ENDING).toString());
    ButtonGroup kinds = new ButtonGroup();
    kinds.add(zip);
    kinds.add(folder);
    zip.addActionListener(e -> follow());
    folder.addActionListener(e -> follow());
    JPanel content = new JPanel(new MigLayout("insets dialog, fillx, wrap 1", "[grow,fill]"));
    content.add(PlainText.only(new JLabel(Texts.of("package.about", name))));
    content.add(zip);
    content.add(folder);
    content.add(row(), "gaptop unrel");
    wrong.getAccessibleContext().setAccessibleName(Texts.of("package.wrong"));
    content.add(wrong, "wmin 0");
    JButton make = Mnemonics.button("package.do");
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    make.addActionListener(e -> confirm());
    cancel.addActionListener(e -> dispose());
    JPanel buttons = new JPanel(new MigLayout("insets 0", "push[sizegroup b][sizegroup b]"));
    buttons.add(make);
    buttons.add(cancel);
    content.add(buttons);
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    WindowPacker.pack(this);
    getRootPane().setDefaultButton(make); // after packing, which takes it away
    setLocationRelativeTo(owner);
  }

  private JPanel row() {
    JPanel row = new JPanel(new MigLayout("insets 0, fillx", "[][grow,fill][]"));
    JLabel label = Mnemonics.label("package.to");
    label.setLabelFor(path);
    path.getAccessibleContext().setAccessibleName(label.getText());
    JButton browse = Mnemonics.button("create.browse");
    browse.addActionListener(e -> browse());
    row.add(label);
    row.add(path);
    row.add(browse);
    return row;
  }

  /** Gives the name the ending of archives, or takes it away. */
  private void follow() {
    String name = path.getText().strip();
    boolean ending = name.toLowerCase(Locale.ROOT).endsWith(ENDING);
    if (zip.isSelected() && !ending) {
      path.setText(name + ENDING);
    } else if (folder.isSelected() && ending) {
      path.setText(name.substring(0, name.length() - ENDING.length()));
    }
  }

  private void browse() {
    NamedFileChooser chooser = new NamedFileChooser();
    if (folder.isSelected()) {
      chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
    }
    chooser.setDialogTitle(Texts.of("package.title"));
    typed().ifPresent(now -> chooser.setSelectedFile(now.toFile()));
    if (chooser.showDialog(this, Texts.of("create.choose")) == JFileChooser.APPROVE_OPTION) {
      path.setText(chooser.chosen().toString());
      follow();
    }
  }

  private Optional<Path> typed() {
    try {
      String name = path.getText().strip();
      return name.isEmpty()
          ? Optional.empty()
          : Optional.of(Path.of(name).toAbsolutePath().normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private void confirm() {
    follow();
    Optional<Path> now = typed();
    if (now.isEmpty() || now.get().getParent() == null) {
      wrong.setText(Texts.of("create.nofile"));
    } else if (!Files.isDirectory(now.get().getParent())) {
      wrong.setText(Texts.of("create.nofolder", String.valueOf(now.get().getParent())));
    } else if (folder.isSelected() && Files.exists(now.get()) && !Files.isDirectory(now.get())) {
      wrong.setText(Texts.of("package.nofolder", now.get().toString()));
    } else {
      target = new Target(now.get(), zip.isSelected());
      dispose();
    }
  }

  /** Shows the dialog and waits; empty if the author cancels. */
  public Optional<Target> ask() {
    FileNameSelection.select(path, ENDING);
    InitialFocus.show(this, path);
    return Optional.ofNullable(target);
  }
}
