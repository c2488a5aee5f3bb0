package org.selectiverenderer.enricher.importing;

import java.awt.Window;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;

/** Asks how a model becomes part of the scene. */
@SuppressWarnings("serial") // never written
public final class ImportDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  /** Names what becomes of the model. */
  public enum Way {
    /** An X3D file beside the scene, with its pictures, is inlined. */
    COPY,
    /** The model itself is inlined. */
    LINK,
    /** It is opened as a scene instead. */
    OPEN
  }

  private final JRadioButton copy =
      Mnemonics.on(new JRadioButton("", true), Texts.of("import.copy"));
  private final JRadioButton link = Mnemonics.on(new JRadioButton(), Texts.of("import.link"));
  private final JRadioButton open = Mnemonics.on(new JRadioButton(), Texts.of("import.open"));
  private boolean agreed;

  /**
   * @param mayLink whether the scene may name the file
   * @param mayOpen whether opening it instead is offered
   */
  public ImportDialog(Window owner, Path file, boolean mayLink, boolean mayOpen) {
    super(owner, Texts.of("import.title"), ModalityType.DOCUMENT_MODAL);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content = new JPanel(new MigLayout("insets dialog, fillx, wrap 1", "[grow,fill]"));
    content.add(
        PlainText.only(new JLabel(Texts.of("import.about", String.valueOf(file.getFileName())))));
    ButtonGroup ways = new ButtonGroup();
    content.add(way(copy, "import.copy.tip", ways));
    content.add(new JLabel(Texts.of("import.copy.tip")), "gapleft indent");
    content.add(way(link, "import.link.tip", ways));
    content.add(
        new JLabel(Texts.of(mayLink ? "import.link.tip" : "import.link.not")), "gapleft indent");
    link.setEnabled(mayLink);
    if (mayOpen) {
      content.add(way(open, "import.open.tip", ways));
    }
    JButton ok = Mnemonics.button("import.do");
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    ok.addActionListener(
        e -> {
          agreed = true;
          dispose();
        });
    cancel.addActionListener(e -> dispose());
    JPanel buttons = new JPanel(new MigLayout("insets 0", "push[sizegroup b][sizegroup b]"));
    buttons.add(ok);
    buttons.add(cancel);
    content.add(buttons, "gaptop unrel");
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    WindowPacker.pack(this);
    getRootPane().setDefaultButton(ok); // after packing, which takes it away
    setLocationRelativeTo(owner);
  }

  private static JRadioButton way(JRadioButton button, String tip, ButtonGroup ways) {
    ways.add(button);
    button.setToolTipText(Texts.of(tip));
    return button;
  }

  /** Shows the dialog and waits; empty if the author cancels. */
  public Optional<Way> ask() {
    setVisible(true);
    if (!agreed) {
      return Optional.empty();
    }
    return Optional.of(copy.isSelected() ? Way.COPY : link.isSelected() ? Way.LINK : Way.OPEN);
  }
}
