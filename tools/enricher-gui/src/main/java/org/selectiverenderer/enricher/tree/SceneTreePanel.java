package org.selectiverenderer.enricher.tree;

import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.AbstractAction;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.ToolTipManager;
import javax.swing.UIManager;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.component.TextChangeListener;
import org.selectiverenderer.enricher.session.ElementPath;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** The panel at the left of the window: search field, filter and tree. */
public final class SceneTreePanel {
  private static final int PAUSE_MILLISECONDS = 150;

  /** Index of the filter that shows the whole scene. */
  private static final int WHOLE = 1;

  private final EnricherSession session;
  private final SceneTreeModel model;
  private final SceneTree tree;
  private final JTextField search = new JTextField();
  private final JComboBox<String> extent =
      new JComboBox<>(new String[] {Texts.of("nodes.extent.some"), Texts.of("nodes.extent.all")});
  private final JTextArea waiting = new JTextArea();
  private final JPanel panel =
      new JPanel(new MigLayout("insets 6, gap 4, fill, hidemode 2", "[grow]", "[][][grow][]"));
  private final SelectionListener selecting = this::follow;
  private final org.selectiverenderer.authoring.DocumentListener changing = this::changed;
  private boolean following;

  /** Of the text whose elements the rows are. */
  private long revision;

  /**
   * @param faulty tests whether an element has a problem
   */
  public SceneTreePanel(EnricherSession session, Predicate<DocumentElement> faulty) {
    this.session = session;
    model = new SceneTreeModel(session.document());
    tree = new SceneTree(model, session);
    tree.setCellRenderer(new NodeTreeCellRenderer(session.enrichment(), faulty));
    tree.setLargeModel(true);
    rowHeight();
    tree.addPropertyChangeListener("font", event -> rowHeight());
    tree.setRootVisible(false);
    tree.setShowsRootHandles(true);
    tree.getSelectionModel().setSelectionMode(TreeSelectionModel.DISCONTIGUOUS_TREE_SELECTION);
    tree.getAccessibleContext().setAccessibleName(Texts.of("nodes.tree"));
    tree.addTreeSelectionListener(event -> chosen());
    ToolTipManager.sharedInstance().registerComponent(tree);
    search.putClientProperty("JTextField.placeholderText", Texts.of("nodes.search.keys"));
    search.putClientProperty("JTextField.showClearButton", true);
    search.getAccessibleContext().setAccessibleName(Texts.of("nodes.search"));
    Timer pause = new Timer(PAUSE_MILLISECONDS, event -> searchNow());
    pause.setRepeats(false);
    search.getDocument().addDocumentListener(new TextChangeListener(pause::restart));
    search.addActionListener(event -> nextHit());
    if (nothingEnrichable()) {
      model.showNodesOnly(false);
      extent.setSelectedIndex(WHOLE);
    }
    extent.getAccessibleContext().setAccessibleName(Texts.of("nodes.extent"));
    extent.addActionListener(event -> extentChosen());
    panel.add(search, "growx, wmin 0, wrap");
    panel.add(extent, "growx, wmin 0, wrap");
    waiting.setName("treeWaits");
    waiting.getAccessibleContext().setAccessibleName(Texts.of("node.treeState"));
    waiting.setEditable(false);
    waiting.setFocusable(false);
    waiting.setOpaque(false);
    waiting.setLineWrap(true);
    waiting.setWrapStyleWord(true);
    waiting.setFont(search.getFont());
    showWaiting();
    JScrollPane scroll = new JScrollPane(tree);
    scroll
        .getVerticalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("nodes.scroll"));
    scroll
        .getHorizontalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("nodes.scroll"));
    panel.add(scroll, "grow, wmin 0, hmin 0, wrap");
    panel.add(waiting, "growx, wmin 0"); // below the tree, which thus does not move
    revision = session.document().revision();
    session.addSelectionListener(selecting);
    session.document().addListener(changing);
    expandTop();
  }

  /** Whether the scene has no Switch and no sensor yet, of which the tree would show nothing. */
  private boolean nothingEnrichable() {
    return session
        .document()
        .tree()
        .filter(tree -> tree.switches().isEmpty() && tree.sensors().isEmpty())
        .isPresent();
  }

  /** Sets the fixed row height, which a large model needs, from the font. */
  private void rowHeight() {
    tree.setRowHeight(tree.getFontMetrics(tree.getFont()).getHeight() + 8);
  }

  public JPanel component() {
    return panel;
  }

  public JTree tree() {
    return tree;
  }

  public JTextField searchField() {
    return search;
  }

  private void searchNow() {
    quietly(() -> model.search(search.getText()));
    shown();
  }

  /** Selects the next hit after the selected element; a single hit also gets the focus. */
  private void nextHit() {
    searchNow();
    if (search.getText().isBlank()) {
      tree.requestFocusInWindow();
      return;
    }
    List<DocumentElement> hits = hits();
    if (hits.isEmpty()) {
      session.message(Texts.of("nodes.nohit", search.getText().strip()));
      return;
    }
    int now = session.selection().map(hits::indexOf).orElse(-1);
    int next = (now + 1) % hits.size();
    session.select(hits.get(next), search);
    session.message(
        Texts.of(
            "nodes.hit",
            DecimalFormatter.grouped(next + 1L),
            DecimalFormatter.grouped(hits.size()),
            hits.get(next)));
    if (hits.size() == 1) {
      tree.requestFocusInWindow();
    }
  }

  /** Returns the hits; without any among objects and areas, switches to the whole scene. */
  private List<DocumentElement> hits() {
    int before = extent.getSelectedIndex();
    if (model.hits().isEmpty() && before != WHOLE) {
      extent.setSelectedIndex(WHOLE);
      if (model.hits().isEmpty()) {
        extent.setSelectedIndex(before);
      }
    }
    return model.hits();
  }

  /**
   * Scrolls to an element, or to the object or area that it belongs to; resets search and filter if
   * they hide it.
   */
  public void reveal(DocumentElement element) {
    if (!model.shows(element) && !search.getText().isEmpty()) {
      search.setText("");
      searchNow();
    }
    if (!model.shows(element)) {
      extent.setSelectedIndex(WHOLE);
    }
    show(List.of(element));
  }

  private void extentChosen() {
    quietly(() -> model.showNodesOnly(extent.getSelectedIndex() != WHOLE));
    shown();
  }

  private void shown() {
    expandTop();
    show(session.selectedElements());
  }

  private void quietly(Runnable change) {
    following = true;
    try {
      change.run();
    } finally {
      following = false;
    }
  }

  /** Expands the root, without which a tree with a hidden root is empty. */
  private void expandTop() {
    Object root = model.getRoot();
    tree.expandPath(new TreePath(root));
    if (!model.flat() && root instanceof DocumentElement) {
      session
          .document()
          .tree()
          .flatMap(ElementTree::scene)
          .flatMap(model::path)
          .ifPresent(tree::expandPath);
    }
  }

  private void chosen() {
    if (following) {
      return;
    }
    TreePath[] paths = tree.getSelectionPaths();
    List<DocumentElement> chosen = new ArrayList<>();
    for (TreePath path : paths == null ? new TreePath[0] : paths) {
      if (path.getLastPathComponent() instanceof DocumentElement element && element.attached()) {
        chosen.add(element);
      }
    }
    TreePath lead = tree.getLeadSelectionPath();
    if (lead != null
        && lead.getLastPathComponent() instanceof DocumentElement last
        && chosen.remove(last)) {
      chosen.add(last); // whose form is shown
    }
    if (!chosen.isEmpty()) {
      session.selectAll(chosen, this);
    }
  }

  private void follow(Optional<DocumentElement> element, Object origin) {
    // While an edit is told to the others, the rows are still those before it.
    if (origin != this && session.document().revision() == revision) {
      show(session.selectedElements());
    }
  }

  /** Shows elements as selected, and scrolls to the last one. */
  private void show(List<DocumentElement> elements) {
    quietly(
        () -> {
          List<TreePath> paths =
              elements.stream().flatMap(each -> model.path(each).stream()).distinct().toList();
          tree.setSelectionPaths(paths.toArray(new TreePath[0]));
          if (!paths.isEmpty()) {
            scrollTo(paths.get(paths.size() - 1));
          }
        });
  }

  /** Sets what moves the nodes that are dragged in the tree. */
  public void onDrop(NodeDrop drop) {
    tree.onDrop(drop);
  }

  /**
   * Sets what a key does while the tree has the focus.
   *
   * @param key as {@link KeyStroke#getKeyStroke(String)} reads it
   * @param name what it does, for the list of keys
   */
  public void onKey(String key, String name, Runnable work) {
    tree.getInputMap().put(KeyStroke.getKeyStroke(key), name);
    tree.getActionMap()
        .put(
            name,
            new AbstractAction(name) {
              private static final long serialVersionUID = 1L;

              @Override
              public void actionPerformed(ActionEvent event) {
                work.run();
              }
            });
  }

  /**
   * Scrolls to a row, sideways too: of deep nodes a tree would show the first letter only, of long
   * names the end only, without the arrows that expand.
   */
  private void scrollTo(TreePath path) {
    tree.makeVisible(path);
    scrollToRow(path);
    // Once more: a scroll bar that comes up for it takes the last row's place.
    SwingUtilities.invokeLater(() -> scrollToRow(path));
  }

  private void scrollToRow(TreePath path) {
    Rectangle row = tree.getPathBounds(path);
    if (row != null) {
      Rectangle seen = tree.getVisibleRect();
      int arrow = Math.max(0, row.x - arrows());
      int enough = row.x + Math.min(row.width, seen.width / 2);
      int end = Math.max(0, row.x + row.width - seen.width);
      boolean there = seen.x <= arrow && enough <= seen.x + seen.width;
      int left = there ? seen.x : enough <= seen.width ? 0 : Math.min(arrow, end);
      tree.scrollRectToVisible(new Rectangle(left, row.y, seen.width, row.height));
    }
  }

  /** The width of what expands a row, before its icon. */
  private static int arrows() {
    return UIManager.getInt("Tree.leftChildIndent") + UIManager.getInt("Tree.rightChildIndent");
  }

  private void changed(org.selectiverenderer.authoring.DocumentListener.Change change) {
    showWaiting();
    revision = change.revision();
    if (session.document().tree().isEmpty()) {
      tree.repaint(); // keeps the last elements, greyed
      return;
    }
    List<ElementPath> expanded = new ArrayList<>();
    var paths = tree.getExpandedDescendants(new TreePath(model.getRoot()));
    if (paths != null && !model.flat()) {
      Collections.list(paths).stream()
          .map(TreePath::getLastPathComponent)
          .filter(DocumentElement.class::isInstance)
          .map(each -> ElementPath.of((DocumentElement) each))
          .forEach(expanded::add);
    }
    quietly(model::refresh);
    session
        .document()
        .tree()
        .ifPresent(
            now ->
                expanded.forEach(
                    each -> each.find(now).flatMap(model::path).ifPresent(tree::expandPath)));
    shown();
    tree.repaint();
  }

  private void showWaiting() {
    waiting.setVisible(session.document().fault().isPresent());
    session
        .document()
        .fault()
        .ifPresent(
            fault ->
                waiting.setText(
                    Texts.of(
                        "node.treeWaits",
                        fault.location().line(),
                        Integer.toString(fault.location().line()),
                        fault.message())));
  }

  /** Stops following the session. */
  public void dispose() {
    session.removeSelectionListener(selecting);
    session.document().removeListener(changing);
  }
}
