package org.selectiverenderer.enricher.insert;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import javax.swing.AbstractAction;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.structure.NodePalette;
import org.selectiverenderer.enricher.component.InputDialog;
import org.selectiverenderer.enricher.component.TextChangeListener;
import org.selectiverenderer.enricher.text.MnemonicText;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Asks which node to insert: those that may go where the selection is, by component, searched. */
final class InsertDialog {
  private final List<NodePalette.Entry> entries;
  private final JTextField search = new JTextField(28);
  private final DefaultTreeModel model = new DefaultTreeModel(new DefaultMutableTreeNode());
  private final JTree tree = new JTree(model);
  private final JLabel goal = new JLabel(" ");

  /**
   * A row that can be chosen.
   *
   * @param name the name by which it is inserted
   * @param title what the row shows
   * @param goal where it goes
   */
  private record Choice(String name, String title, String goal) {
    @Override
    public String toString() {
      return title;
    }
  }

  InsertDialog(NodePalette palette, Optional<DocumentElement> selected) {
    entries = palette.entries(selected);
    search.putClientProperty("JTextField.placeholderText", Texts.of("insert.search"));
    search.putClientProperty("JTextField.showClearButton", true);
    search.getAccessibleContext().setAccessibleName(Texts.of("insert.search"));
    search.getDocument().addDocumentListener(new TextChangeListener(this::fill));
    key("DOWN", 1);
    key("UP", -1);
    tree.setRootVisible(false);
    tree.setShowsRootHandles(true);
    tree.getSelectionModel().setSelectionMode(TreeSelectionModel.SINGLE_TREE_SELECTION);
    tree.getAccessibleContext().setAccessibleName(Texts.of("insert.nodes"));
    DefaultTreeCellRenderer rows = new DefaultTreeCellRenderer();
    rows.setLeafIcon(null);
    rows.setOpenIcon(null);
    rows.setClosedIcon(null);
    PlainText.only(rows);
    tree.setCellRenderer(rows);
    tree.addTreeSelectionListener(
        event -> goal.setText(chosen().map(Choice::goal).map(PlainText::of).orElse(" ")));
    goal.setName("insertGoal");
    fill();
  }

  private void key(String key, int step) {
    search.getInputMap().put(KeyStroke.getKeyStroke(key), key);
    search
        .getActionMap()
        .put(
            key,
            new AbstractAction() {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                choose(step);
              }
            });
  }

  /** Selects the next or previous row that can be chosen. */
  private void choose(int step) {
    int row = tree.getLeadSelectionRow();
    for (int at = row + step; at >= 0 && at < tree.getRowCount(); at += step) {
      if (choice(tree.getPathForRow(at)).isPresent()) {
        tree.setSelectionRow(at);
        tree.scrollRowToVisible(at);
        return;
      }
    }
  }

  private static Optional<Choice> choice(TreePath path) {
    return path.getLastPathComponent() instanceof DefaultMutableTreeNode node
            && node.getUserObject() instanceof Choice choice
        ? Optional.of(choice)
        : Optional.empty();
  }

  private Optional<Choice> chosen() {
    return Optional.ofNullable(tree.getSelectionPath()).flatMap(InsertDialog::choice);
  }

  /** Lists what has the searched word in its name, its component or the text of its template. */
  private void fill() {
    String word = search.getText().strip().toLowerCase(Locale.ROOT);
    DefaultMutableTreeNode root = new DefaultMutableTreeNode();
    DefaultMutableTreeNode ready = new DefaultMutableTreeNode(Texts.of("insert.ready"));
    for (String name : InsertCommands.TEMPLATES) {
      String title = name.isEmpty() ? "" : MnemonicText.of(Texts.of("insert." + name)).words();
      if (!name.isEmpty() && (title + " " + name).toLowerCase(Locale.ROOT).contains(word)) {
        ready.add(leaf(new Choice(name, title, Texts.of("insert.ready.goal"))));
      }
    }
    Map<String, DefaultMutableTreeNode> components = new TreeMap<>();
    DefaultMutableTreeNode exact = null;
    for (NodePalette.Entry entry : entries) {
      String name = entry.type().name();
      String component = entry.type().component();
      if ((name + " " + component).toLowerCase(Locale.ROOT).contains(word)) {
        DefaultMutableTreeNode row = leaf(new Choice(name, name, goal(entry)));
        components.computeIfAbsent(component, DefaultMutableTreeNode::new).add(row);
        exact = name.toLowerCase(Locale.ROOT).equals(word) ? row : exact;
      }
    }
    if (ready.getChildCount() > 0) {
      root.add(ready);
    }
    components.values().forEach(root::add);
    model.setRoot(root);
    for (int row = 0; row < tree.getRowCount(); row++) {
      tree.expandRow(row);
    }
    tree.clearSelection();
    if (exact != null) {
      TreePath path = new TreePath(exact.getPath());
      tree.setSelectionPath(path);
      tree.scrollPathToVisible(path);
    } else if (root.getChildCount() > 0) {
      tree.setSelectionRow(1);
      tree.scrollRowToVisible(0);
    }
  }

  private static DefaultMutableTreeNode leaf(Choice choice) {
    return new DefaultMutableTreeNode(choice);
  }

  private static String goal(NodePalette.Entry entry) {
    return Texts.of("insert.goal", entry.into().toString(), entry.field());
  }

  /** Shows the dialog; gives the name of the chosen template or node, empty if cancelled. */
  Optional<String> ask(Component over) {
    JPanel content =
        new JPanel(new MigLayout("insets 0, fill, wrap 1", "[grow,fill]", "[][grow,fill][]"));
    content.add(search);
    JScrollPane scroll = new JScrollPane(tree);
    scroll.setPreferredSize(new Dimension(380, 420));
    content.add(scroll, "grow, hmin 120");
    content.add(goal, "wmin 0");
    boolean accepted =
        new InputDialog(over, Texts.of("insert.title"), content, search)
            .ask(
                () ->
                    chosen().isPresent()
                        ? Optional.empty()
                        : Optional.of(Texts.of("insert.nothing")));
    return accepted ? chosen().map(Choice::name) : Optional.empty();
  }
}
