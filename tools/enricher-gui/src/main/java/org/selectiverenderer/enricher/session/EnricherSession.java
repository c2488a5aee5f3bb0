package org.selectiverenderer.enricher.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichmentEdits;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.enricher.task.TaskExecutor;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * One open document and its selection. For the event dispatch thread only.
 *
 * <p>Several elements may be selected. The selection outlives edits: when the document is parsed
 * again, the elements with the same DEF name or path are selected again; while the text is not well
 * formed, nothing is selected. Undoing a step selects what was selected before it, redoing it what
 * was selected after it.
 */
public final class EnricherSession {
  private final DocumentFile file;
  private final NodeCatalogue catalogue;
  private final TaskExecutor tasks;
  private final Consumer<String> messages;
  private final DocumentEnrichment enrichment;
  private final EnrichmentEdits edits;
  private final List<SelectionListener> listeners = new CopyOnWriteArrayList<>();
  private final DocumentListener following = this::follow;
  private final SelectionHistory history =
      new SelectionHistory(this::selectedElements, this::again);
  private volatile ContentAccessPolicy access;
  private List<DocumentElement> selected = List.of();
  private List<DocumentElement> lost = List.of();

  /** Creates a session with a scene that may read no other than its own files. */
  public EnricherSession(
      DocumentFile file, NodeCatalogue catalogue, TaskExecutor tasks, Consumer<String> messages) {
    this(file, catalogue, ContentAccessPolicy.none(), tasks, messages);
  }

  /**
   * @param access folders and hosts that the scene may read from
   * @param tasks executes work in the background
   * @param messages shows a message in the status bar
   */
  public EnricherSession(
      DocumentFile file,
      NodeCatalogue catalogue,
      ContentAccessPolicy access,
      TaskExecutor tasks,
      Consumer<String> messages) {
    this.file = file;
    this.access = access;
    this.catalogue = catalogue;
    this.tasks = tasks;
    this.messages = messages;
    this.enrichment = new DocumentEnrichment(file.document(), catalogue);
    this.edits = new EnrichmentEdits(enrichment);
    file.document().addListener(following);
    file.document().history().addListener(history);
  }

  public DocumentFile file() {
    return file;
  }

  public SceneDocument document() {
    return file.document();
  }

  public NodeCatalogue catalogue() {
    return catalogue;
  }

  public DocumentEnrichment enrichment() {
    return enrichment;
  }

  public EnrichmentEdits edits() {
    return edits;
  }

  /** The folders and hosts that the scene may read from; may be called on any thread. */
  public ContentAccessPolicy access() {
    return access;
  }

  /**
   * Sets the folders and hosts that the scene may read from, from the next time that it is read.
   */
  public void allow(ContentAccessPolicy now) {
    access = now;
  }

  public TaskExecutor tasks() {
    return tasks;
  }

  /** Shows a message in the status bar, without interrupting the author. */
  public void message(String sentence) {
    messages.accept(Remarks.shown(sentence));
  }

  /**
   * The element that forms and single-node commands work on: the one selected last; empty for none.
   */
  public Optional<DocumentElement> selection() {
    return selected.isEmpty() ? Optional.empty() : Optional.of(selected.get(selected.size() - 1));
  }

  /**
   * All selected elements in the order in which they were selected; {@link #selection} is the last.
   */
  public List<DocumentElement> selectedElements() {
    return selected;
  }

  /**
   * Selects an element.
   *
   * @param element null for none
   * @param origin the view that selects it
   */
  public void select(@Nullable DocumentElement element, Object origin) {
    selectAll(element == null ? List.of() : List.of(element), origin);
  }

  /**
   * Selects several elements.
   *
   * @param elements those to select; the last becomes {@link #selection}, one named twice counts
   *     once
   * @param origin the view that selects them
   */
  public void selectAll(List<DocumentElement> elements, Object origin) {
    lost = List.of();
    show(elements.stream().filter(DocumentElement::attached).toList(), origin);
  }

  private void show(List<DocumentElement> elements, Object origin) {
    List<DocumentElement> now = elements.stream().distinct().toList();
    if (!now.equals(selected)) {
      selected = now;
      tell(origin);
    }
  }

  private void tell(Object origin) {
    Optional<DocumentElement> last = selection();
    listeners.forEach(listener -> listener.selected(last, origin));
  }

  public void addSelectionListener(SelectionListener listener) {
    listeners.add(listener);
  }

  public void removeSelectionListener(SelectionListener listener) {
    listeners.remove(listener);
  }

  /** Makes an edit; tells the author why if it is refused. */
  public void perform(Edit edit) {
    attempt(() -> document().perform(edit));
  }

  /**
   * Runs code that creates and makes an edit; tells the author why if it is refused.
   *
   * @return whether it was made
   */
  public boolean attempt(Runnable making) {
    try {
      making.run();
      return true;
    } catch (EditRejectedException e) {
      messages.accept(Remarks.of(e));
      return false;
    }
  }

  private void follow(DocumentListener.Change change) {
    List<DocumentElement> before = selected.isEmpty() ? lost : selected;
    if (before.isEmpty() || before.stream().allMatch(DocumentElement::attached)) {
      return;
    }
    Optional<ElementTree> tree = document().tree();
    lost = tree.isEmpty() ? before : List.of();
    show(
        tree.map(found -> before.stream().flatMap(e -> findAgain(e, found).stream()).toList())
            .orElse(List.of()),
        this);
  }

  private static Optional<DocumentElement> findAgain(DocumentElement element, ElementTree tree) {
    return element.attached() ? Optional.of(element) : ElementPath.of(element).find(tree);
  }

  /** Selects the elements of paths as far as they are found. */
  private void again(List<ElementPath> paths) {
    document()
        .tree()
        .map(tree -> paths.stream().flatMap(path -> path.find(tree).stream()).toList())
        .filter(found -> !found.isEmpty())
        .ifPresent(found -> selectAll(found, this));
  }

  /** Stops following the document. */
  public void dispose() {
    document().history().removeListener(history);
    document().removeListener(following);
    listeners.clear();
  }
}
