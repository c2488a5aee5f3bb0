package org.selectiverenderer.enricher.access;

import java.awt.Component;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.component.InitialFocus;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.settings.AllowedPlaces;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.swing.WindowPacker;
import org.selectiverenderer.x3d.url.HostPattern;

/** Shows and changes the folders and hosts that a scene may read from. */
@SuppressWarnings("serial") // never written
public final class AccessDialog extends JDialog {
  private static final long serialVersionUID = 1L;

  private final Path scene;
  private final DefaultListModel<Path> folders = new DefaultListModel<>();
  private final DefaultListModel<HostPattern> hosts = new DefaultListModel<>();
  private final JList<Path> folderList = PlainText.entries(new JList<>(folders));
  private final JList<HostPattern> hostList = PlainText.entries(new JList<>(hosts));
  private final JTextField host = new JTextField(20);
  private final JLabel wrong = PlainText.only(new JLabel(" "));
  private boolean agreed;

  /**
   * @param scene the scene that may read from them
   * @param before what it may read from now
   */
  public AccessDialog(Window owner, Path scene, AllowedPlaces before) {
    super(owner, Mnemonics.without(Texts.of("access.title")), ModalityType.DOCUMENT_MODAL);
    this.scene = scene.toAbsolutePath();
    before.folders().forEach(folders::addElement);
    before.hosts().forEach(hosts::addElement);
    setDefaultCloseOperation(DISPOSE_ON_CLOSE);
    JPanel content = new JPanel(new MigLayout("insets dialog, fill, wrap 1", "[grow,fill]"));
    content.add(
        PlainText.only(new JLabel(Texts.of("access.about", String.valueOf(scene.getFileName())))));
    content.add(folders(), "grow, push");
    content.add(hosts(), "grow, push, gaptop unrel");
    wrong.getAccessibleContext().setAccessibleName(Texts.of("access.wrong"));
    content.add(wrong, "wmin 0");
    JButton ok = new JButton(Texts.of("window.ok"));
    JButton cancel = new JButton(Texts.of("keep.cancel"));
    ok.addActionListener(e -> confirm());
    cancel.addActionListener(e -> dispose());
    JPanel buttons = new JPanel(new MigLayout("insets 0", "push[sizegroup b][sizegroup b]"));
    buttons.add(ok);
    buttons.add(cancel);
    content.add(buttons);
    setContentPane(content);
    getRootPane()
        .registerKeyboardAction(
            e -> dispose(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
    WindowPacker.pack(this);
    getRootPane().setDefaultButton(ok); // after packing, which takes it away
    setLocationRelativeTo(owner);
  }

  private JComponent folders() {
    JButton add = Mnemonics.button("access.folder.add");
    JButton remove = Mnemonics.button("access.folder.remove");
    add.addActionListener(e -> chooseFolder());
    return part("access.folders", folderList, folders, remove, add);
  }

  private JComponent hosts() {
    host.getAccessibleContext().setAccessibleName(Texts.of("access.host"));
    host.putClientProperty("JTextField.placeholderText", "*.example.org");
    JButton add = Mnemonics.button("access.host.add");
    JButton remove = Mnemonics.button("access.host.remove");
    add.addActionListener(e -> addHost());
    host.addActionListener(e -> enter());
    return part("access.hosts", hostList, hosts, remove, host, add);
  }

  private static JComponent part(
      String title, JList<?> list, DefaultListModel<?> entries, JButton remove, Component... adds) {
    JPanel panel = new JPanel(new MigLayout("insets 0, fill, wrap 1", "[grow,fill]"));
    JLabel label = Mnemonics.label(title);
    label.setLabelFor(list);
    list.getAccessibleContext().setAccessibleName(label.getText());
    list.setVisibleRowCount(5);
    remove.setEnabled(false);
    list.addListSelectionListener(e -> remove.setEnabled(!list.isSelectionEmpty()));
    remove.addActionListener(e -> remove(list, entries));
    list.registerKeyboardAction(
        e -> remove(list, entries), KeyStroke.getKeyStroke("DELETE"), JComponent.WHEN_FOCUSED);
    panel.add(label);
    panel.add(new JScrollPane(list), "grow, push, hmin 70, wmin 420");
    JPanel row = new JPanel(new MigLayout("insets 0"));
    for (Component each : adds) {
      row.add(each);
    }
    row.add(remove);
    panel.add(row);
    return panel;
  }

  private static void remove(JList<?> list, DefaultListModel<?> entries) {
    int[] chosen = list.getSelectedIndices();
    for (int i = chosen.length - 1; i >= 0; i--) {
      entries.remove(chosen[i]);
    }
  }

  private void chooseFolder() {
    NamedFileChooser chooser = new NamedFileChooser();
    chooser.setFileSelectionMode(JFileChooser.DIRECTORIES_ONLY);
    chooser.setDialogTitle(Texts.of("access.folder.title"));
    Optional.ofNullable(scene.getParent())
        .ifPresent(folder -> chooser.setCurrentDirectory(folder.toFile()));
    if (chooser.showDialog(this, Texts.of("access.folder.choose")) == JFileChooser.APPROVE_OPTION) {
      allow(chooser.chosen());
    }
  }

  /** Adds a folder to the list, once; a file is not added, which is said. */
  public void allow(Path folder) {
    Path whole = folder.toAbsolutePath().normalize();
    if (!Files.isDirectory(whole)) {
      wrong.setText(Texts.of("access.folder.none", whole.toString()));
    } else if (!folders.contains(whole)) {
      folders.addElement(whole);
      wrong.setText(" ");
    }
  }

  /** Adds the host that was typed; where none is, Enter is for the default button. */
  private void enter() {
    if (host.getText().isBlank()) {
      confirm();
    } else {
      addHost();
    }
  }

  /** Adds the host that was typed, unless it is none, which is said. */
  private boolean addHost() {
    String typed = host.getText().strip();
    if (typed.isEmpty()) {
      return true;
    }
    try {
      HostPattern pattern = new HostPattern(typed);
      if (!hosts.contains(pattern)) {
        hosts.addElement(pattern);
      }
      host.setText("");
      wrong.setText(" ");
      return true;
    } catch (IllegalArgumentException e) {
      wrong.setText(PlainText.of(String.valueOf(e.getMessage())));
      return false;
    }
  }

  private void confirm() {
    if (addHost()) { // what is typed but not added is meant too
      agreed = true;
      dispose();
    }
  }

  /** Shows the dialog and waits; empty if the author cancels. */
  public Optional<AllowedPlaces> ask() {
    InitialFocus.show(this, host);
    return agreed ? Optional.of(chosen()) : Optional.empty();
  }

  private AllowedPlaces chosen() {
    return new AllowedPlaces(list(folders), list(hosts));
  }

  private static <E> List<E> list(DefaultListModel<E> model) {
    List<E> all = new ArrayList<>();
    for (int i = 0; i < model.size(); i++) {
      all.add(model.get(i));
    }
    return all;
  }
}
