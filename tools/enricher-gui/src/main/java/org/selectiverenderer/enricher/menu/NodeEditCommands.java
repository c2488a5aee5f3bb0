package org.selectiverenderer.enricher.menu;

import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.List;
import java.util.function.Predicate;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.editing.CommentToggle;
import org.selectiverenderer.authoring.editing.ElementEdits;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The commands that cut, copy, paste, delete or comment out any node, each as one undo step. */
public final class NodeEditCommands {
  private final EnricherSession session;
  private final Clipboard clipboard;

  private NodeEditCommands(EnricherSession session, Clipboard clipboard) {
    this.session = session;
    this.clipboard = clipboard;
  }

  public static List<NodeCommand> of(EnricherSession session, Clipboard clipboard) {
    NodeEditCommands editing = new NodeEditCommands(session, clipboard);
    Predicate<DocumentElement> free = element -> session.document().locked().isEmpty();
    Predicate<DocumentElement> removable = free.and(NodeEdits::removable);
    return List.of(
        new NodeCommand("cutNode", Texts.of("node.cut"), removable, editing::cut),
        new NodeCommand("copyNode", Texts.of("node.copy"), element -> true, editing::copy),
        new NodeCommand("pasteNode", Texts.of("node.paste"), free, editing::paste),
        new NodeCommand("deleteNode", Texts.of("node.delete"), removable, editing::delete),
        new NodeCommand("commentNode", Texts.of("node.comment"), removable, editing::comment));
  }

  private SceneDocument document() {
    return session.document();
  }

  private ElementEdits edits() {
    return new ElementEdits(document());
  }

  private void copy(DocumentElement element) {
    put(document().text(element));
  }

  private boolean put(String text) {
    try {
      clipboard.setContents(new StringSelection(text), null);
      return true;
    } catch (IllegalStateException e) {
      session.message(Texts.of("node.clipboardBusy"));
      return false;
    }
  }

  private void cut(DocumentElement element) {
    session.attempt(
        () -> {
          Edit edit = edits().remove(element, Texts.of("node.cutStep", element));
          if (put(document().text(element))) {
            document().perform(edit);
          }
        });
  }

  private void delete(DocumentElement element) {
    session.attempt(() -> document().perform(new NodeEdits(document()).remove(element)));
  }

  private void comment(DocumentElement element) {
    session.attempt(
        () ->
            document()
                .perform(
                    CommentToggle.toggle(
                        document().text(),
                        element.start(),
                        element.end(),
                        Texts.of("node.commentStep", element))));
  }

  private void paste(DocumentElement element) {
    try {
      String text = String.valueOf(clipboard.getData(DataFlavor.stringFlavor));
      session.attempt(
          () -> document().perform(edits().paste(element, text, Texts.of("node.pasteStep"))));
    } catch (UnsupportedFlavorException | IOException e) {
      session.message(Texts.of("node.noText"));
    } catch (IllegalStateException e) {
      session.message(Texts.of("node.clipboardBusy"));
    }
  }
}
