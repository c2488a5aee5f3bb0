package org.selectiverenderer.enricher.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.document.DocumentListener;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.enrichment.Enrichment;
import org.selectiverenderer.document.enrichment.EnrichmentEdits;
import org.selectiverenderer.document.file.DocumentFile;
import org.selectiverenderer.enricher.task.Tasks;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * One open document and what is selected in it. For the event dispatch thread only.
 *
 * <p>The selection outlives edits: when the document's elements are read anew, the element of the
 * same name or place is selected again; while the text is not well formed, none is.
 */
public final class EnricherSession {
  private final DocumentFile file;
  private final NodeCatalogue catalogue;
  private final ContentAccess access;
  private final Tasks tasks;
  private final Consumer<String> messages;
  private final Enrichment enrichment;
  private final EnrichmentEdits edits;
  private final List<SelectionListener> listeners = new CopyOnWriteArrayList<>();
  private final DocumentListener following = this::follow;
  private @Nullable DocumentElement selection;
  private @Nullable DocumentElement lost;

  /** A session with a scene that may name no more than its own files. */
  public EnricherSession(
      DocumentFile file, NodeCatalogue catalogue, Tasks tasks, Consumer<String> messages) {
    this(file, catalogue, ContentAccess.none(), tasks, messages);
  }

  /**
   * @param access what the scene may name besides its own files
   * @param tasks for work in the background
   * @param messages shows a sentence to the author
   */
  public EnricherSession(
      DocumentFile file,
      NodeCatalogue catalogue,
      ContentAccess access,
      Tasks tasks,
      Consumer<String> messages) {
    this.file = file;
    this.access = access;
    this.catalogue = catalogue;
    this.tasks = tasks;
    this.messages = messages;
    this.enrichment = new Enrichment(file.document(), catalogue);
    this.edits = new EnrichmentEdits(enrichment);
    file.document().addListener(following);
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

  public Enrichment enrichment() {
    return enrichment;
  }

  public EnrichmentEdits edits() {
    return edits;
  }

  /** What the scene may name besides its own files. */
  public ContentAccess access() {
    return access;
  }

  public Tasks tasks() {
    return tasks;
  }

  /** Shows a sentence to the author, who can go on working. */
  public void message(String sentence) {
    messages.accept(sentence);
  }

  /** The selected element; empty for none. */
  public Optional<DocumentElement> selection() {
    return Optional.ofNullable(selection);
  }

  /**
   * Selects an element.
   *
   * @param element null for none
   * @param origin the view that does it
   */
  public void select(@Nullable DocumentElement element, Object origin) {
    lost = null;
    DocumentElement now = element != null && element.attached() ? element : null;
    if (now != selection) {
      selection = now;
      tell(origin);
    }
  }

  private void tell(Object origin) {
    Optional<DocumentElement> selected = selection();
    listeners.forEach(listener -> listener.selected(selected, origin));
  }

  public void addSelectionListener(SelectionListener listener) {
    listeners.add(listener);
  }

  public void removeSelectionListener(SelectionListener listener) {
    listeners.remove(listener);
  }

  /** Makes an edit; one that would do harm is not made, and the author is told why. */
  public void perform(Edit edit) {
    attempt(() -> document().perform(edit));
  }

  /**
   * Makes an edit that has to be worked out first.
   *
   * @return whether it was made
   */
  public boolean attempt(Runnable making) {
    try {
      making.run();
      return true;
    } catch (EditRefused e) {
      messages.accept(String.valueOf(e.getMessage()));
      return false;
    }
  }

  private void follow(DocumentListener.Change change) {
    if (selection == null && lost == null || selection != null && selection.attached()) {
      return;
    }
    DocumentElement before = selection != null ? selection : lost;
    selection = document().tree().flatMap(tree -> ElementPath.of(before).find(tree)).orElse(null);
    lost = selection == null && document().tree().isEmpty() ? before : null;
    tell(this);
  }

  /** Lets go of the document. */
  public void dispose() {
    document().removeListener(following);
    listeners.clear();
  }
}
