package org.selectiverenderer.enricher.tree;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.event.TreeModelEvent;
import javax.swing.event.TreeModelListener;
import javax.swing.tree.TreeModel;
import javax.swing.tree.TreePath;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * The tree model of a document's elements, which a tree reads lazily. With a search, or when only
 * Switches and ProximitySensors are shown, the elements are a flat list under the root.
 */
final class SceneTreeModel implements TreeModel {
  private static final String EMPTY = "";

  private final SceneDocument document;
  private final List<TreeModelListener> listeners = new CopyOnWriteArrayList<>();
  private boolean nodesOnly = true;
  private String search = "";
  private @Nullable List<DocumentElement> list;

  /** The last well-formed tree, whose elements are detached while the text is not well formed. */
  private @Nullable ElementTree last;

  public SceneTreeModel(SceneDocument document) {
    this.document = document;
    refresh();
  }

  public void showNodesOnly(boolean only) {
    nodesOnly = only;
    refresh();
  }

  /** Shows only elements whose name, DEF or USE contains a text; all for an empty one. */
  public void search(String text) {
    search = text.strip().toLowerCase(Locale.ROOT);
    refresh();
  }

  /** Whether the elements are shown as a flat list. */
  public boolean flat() {
    return nodesOnly || !search.isEmpty();
  }

  /** Updates the model from the document. */
  public void refresh() {
    List<DocumentElement> now = flat() ? found() : null;
    boolean same = now != null && now.equals(list);
    list = now;
    if (!same) {
      TreeModelEvent event = new TreeModelEvent(this, new TreePath(getRoot()));
      listeners.forEach(listener -> listener.treeStructureChanged(event));
    }
  }

  private Optional<ElementTree> tree() {
    document.tree().ifPresent(now -> last = now);
    return Optional.ofNullable(last);
  }

  private List<DocumentElement> found() {
    Optional<ElementTree> tree = tree();
    if (tree.isEmpty()) {
      return List.of();
    }
    List<DocumentElement> found = new ArrayList<>();
    if (nodesOnly) {
      found.addAll(tree.get().switches());
      found.addAll(tree.get().sensors());
      found.sort(Comparator.comparingInt(DocumentElement::start));
      found.removeIf(element -> !matches(element));
    } else {
      tree.get()
          .root()
          .visit(
              element -> {
                if (matches(element)) {
                  found.add(element);
                }
              });
    }
    return found;
  }

  private boolean matches(DocumentElement element) {
    return search.isEmpty()
        || element.name().toLowerCase(Locale.ROOT).contains(search)
        || element.def().orElse("").toLowerCase(Locale.ROOT).contains(search)
        || element.use().orElse("").toLowerCase(Locale.ROOT).contains(search);
  }

  /** The elements that match the search; empty without a search. */
  List<DocumentElement> hits() {
    return list == null || search.isEmpty() ? List.of() : List.copyOf(list);
  }

  /** Whether a row shows an element, or the object or area that it belongs to. */
  boolean shows(DocumentElement element) {
    if (list == null) {
      return true;
    }
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (list.contains(at)) {
        return at == element || at.name().equals("Switch") || at.name().equals("ProximitySensor");
      }
    }
    return false;
  }

  /** The path of an element from the root, or of the nearest shown element around it. */
  public Optional<TreePath> path(DocumentElement element) {
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (list == null) {
        return Optional.of(new TreePath(lineage(at).toArray()));
      }
      if (list.contains(at)) {
        return Optional.of(new TreePath(new Object[] {getRoot(), at}));
      }
    }
    return Optional.empty();
  }

  private static List<DocumentElement> lineage(DocumentElement element) {
    List<DocumentElement> lineage = new ArrayList<>();
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      lineage.add(0, at);
    }
    return lineage;
  }

  @Override
  public Object getRoot() {
    return tree().<Object>map(ElementTree::root).orElse(EMPTY);
  }

  private List<DocumentElement> children(Object parent) {
    if (list != null) {
      return parent == getRoot() ? list : List.of();
    }
    return parent instanceof DocumentElement element ? element.children() : List.of();
  }

  @Override
  public Object getChild(Object parent, int index) {
    return children(parent).get(index);
  }

  @Override
  public int getChildCount(Object parent) {
    return children(parent).size();
  }

  @Override
  public boolean isLeaf(Object node) {
    return children(node).isEmpty();
  }

  @Override
  public void valueForPathChanged(TreePath path, Object value) {
    throw new UnsupportedOperationException("the tree is not edited in place");
  }

  @Override
  public int getIndexOfChild(Object parent, Object child) {
    return children(parent).indexOf(child);
  }

  @Override
  public void addTreeModelListener(TreeModelListener listener) {
    listeners.add(listener);
  }

  @Override
  public void removeTreeModelListener(TreeModelListener listener) {
    listeners.remove(listener);
  }
}
