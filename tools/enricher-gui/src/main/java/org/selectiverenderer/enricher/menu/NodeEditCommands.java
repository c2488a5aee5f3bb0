package org.selectiverenderer.enricher.menu;

import java.util.List;
import java.util.function.Predicate;
import org.selectiverenderer.authoring.editing.CommentToggle;
import org.selectiverenderer.authoring.nodes.NodeEdits;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The commands of the context menu that cut, copy, paste, delete or comment out any node. */
public final class NodeEditCommands {
  private final EnricherSession session;

  private NodeEditCommands(EnricherSession session) {
    this.session = session;
  }

  public static List<NodeCommand> of(EnricherSession session, StructureCommands structure) {
    NodeEditCommands editing = new NodeEditCommands(session);
    Predicate<DocumentElement> free = element -> session.document().locked().isEmpty();
    Predicate<DocumentElement> removable = free.and(NodeEdits::removable);
    Predicate<DocumentElement> all = element -> structure.removable();
    return List.of(
        new NodeCommand("cutNode", Texts.of("node.cut"), "ctrl X", all, element -> structure.cut()),
        new NodeCommand(
            "copyNode", Texts.of("node.copy"), "ctrl C", element -> true, e -> structure.copy()),
        new NodeCommand(
            "pasteNode", Texts.of("node.paste"), "ctrl V", free, element -> structure.paste()),
        new NodeCommand(
            "deleteNode", Texts.of("node.delete"), "DELETE", all, element -> structure.delete()),
        new NodeCommand("commentNode", Texts.of("node.comment"), removable, editing::comment));
  }

  private void comment(DocumentElement element) {
    session.attempt(
        () ->
            session
                .document()
                .perform(
                    CommentToggle.toggle(
                        session.document().text(),
                        element.start(),
                        element.end(),
                        Texts.of("node.commentStep", element))));
  }
}
