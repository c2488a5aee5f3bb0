package org.selectiverenderer.enricher.form;

import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The controls of a Switch as a whole: which choice shows at the start, adding choices, unwrapping;
 * and the buttons of each choice.
 */
final class SwitchControls {
  private final EnricherSession session;
  private final NodeCommands nodes;
  private final DocumentElement element;
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, hidemode 3, wrap 3", "[][grow,fill][]"));
  private final JComboBox<String> shown = PlainText.entries(new JComboBox<>());
  private final JButton add = new JButton(Texts.of("area.switch.add") + " \u25be");
  private final FieldBinding field;

  SwitchControls(EnricherSession session, NodeCommands nodes, EnrichedSwitch node) {
    this.session = session;
    this.nodes = nodes;
    this.element = node.element();
    boolean writable = session.document().locked().isEmpty();
    shown.addItem(title(-1));
    for (int i = 0; i < node.choices().size(); i++) {
      shown.addItem(title(i));
    }
    shown.setName("Shown at the start");
    shown.getAccessibleContext().setAccessibleName(Texts.of("area.switch.show"));
    shown.setToolTipText("whichChoice");
    shown.setEnabled(writable);
    add.setName("Add choice");
    add.setEnabled(writable);
    add.addActionListener(event -> menu().show(add, 0, add.getHeight()));
    JLabel complaint = LabelFactory.complaint();
    panel.add(LabelFactory.of(Texts.of("area.switch.show"), shown));
    panel.add(shown, "wmin 0");
    panel.add(add);
    panel.add(complaint, "spanx 3, wmin 0");
    field =
        FieldBinding.of(
            shown,
            complaint,
            new FieldBinding.Source(
                () -> title(node().map(EnrichedSwitch::whichChoice).orElse(-1)), this::show));
  }

  private static String title(int choice) {
    return choice < 0
        ? Texts.of("area.switch.show.none")
        : Texts.of("area.switch.show.one", String.valueOf(choice));
  }

  private Optional<EnrichedSwitch> node() {
    return nodes.switchNode(element);
  }

  private Optional<String> show(String title) {
    node()
        .ifPresent(
            now -> {
              int choice = shown.getSelectedIndex() - 1;
              boolean same = title(now.whichChoice()).equals(title);
              if (!same) {
                nodes.perform(() -> nodes.switches().show(now, choice));
              }
            });
    return Optional.empty();
  }

  private interface Making {
    Edit of(EnrichedSwitch now);
  }

  private void edit(Making making) {
    node().ifPresent(now -> nodes.perform(() -> making.of(now)));
  }

  private JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.add(item(Texts.of("area.switch.add.inline"), this::addFile));
    int choices = node().map(now -> now.choices().size()).orElse(0);
    for (int i = 0; i < choices; i++) {
      int index = i;
      menu.add(
          item(
              Texts.of("area.switch.add.copy", String.valueOf(i)),
              () -> edit(now -> nodes.switches().addCopy(now, index))));
    }
    menu.add(
        item(Texts.of("area.switch.add.empty"), () -> edit(now -> nodes.switches().addEmpty(now))));
    return menu;
  }

  private static JMenuItem item(String text, Runnable does) {
    MnemonicText title = MnemonicText.of(text);
    JMenuItem item = new JMenuItem(title.words(), title.letter());
    item.addActionListener(event -> does.run());
    return item;
  }

  private void addFile() {
    Path scene = session.file().path().toAbsolutePath().getParent();
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setCurrentDirectory(scene == null ? null : scene.toFile());
    chooser.setDialogTitle(Texts.of("area.switch.inline.title"));
    if (chooser.showOpenDialog(panel) == JFileChooser.APPROVE_OPTION) {
      add(chooser.chosen().toFile());
    }
  }

  /** Adds a choice that inlines a file. */
  void add(File file) {
    edit(now -> nodes.switches().addInline(now, url(file.toPath())));
  }

  /**
   * Returns the url of a file: relative to the scene's folder where both are on one drive, else
   * absolute.
   */
  private String url(Path file) {
    Path folder = session.file().path().toAbsolutePath().getParent();
    Path path = file.toAbsolutePath().normalize();
    boolean near = folder != null && Objects.equals(folder.getRoot(), path.getRoot());
    return near
        ? folder.normalize().relativize(path).toString().replace(File.separatorChar, '/')
        : path.toUri().toString();
  }

  /** Creates the buttons that move and delete a choice. */
  JPanel buttons(int index, int size) {
    JPanel row = new JPanel(new MigLayout("insets 0, gapx 2", ""));
    List<JButton> all = new ArrayList<>();
    all.add(
        small(
            "\u25b2",
            "area.switch.up",
            index,
            () -> edit(now -> nodes.switches().swap(now, index, index - 1))));
    all.add(
        small(
            "\u25bc",
            "area.switch.down",
            index,
            () -> edit(now -> nodes.switches().swap(now, index, index + 1))));
    all.add(
        small(
            "\u2715",
            "area.switch.remove",
            index,
            () -> edit(now -> nodes.switches().remove(now, index))));
    boolean writable = session.document().locked().isEmpty();
    all.get(0).setEnabled(writable && index > 0);
    all.get(1).setEnabled(writable && index + 1 < size);
    all.get(2).setEnabled(writable);
    all.forEach(row::add);
    return row;
  }

  private static JButton small(String sign, String key, int index, Runnable does) {
    String tip = Texts.of(key, String.valueOf(index));
    JButton button = new JButton(sign);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(tip);
    button.setName(key + "." + index);
    button.addActionListener(event -> does.run());
    return button;
  }

  void unwrap() {
    edit(now -> nodes.switches().unwrap(now));
  }

  JPanel component() {
    return panel;
  }

  FieldBinding field() {
    return field;
  }
}
