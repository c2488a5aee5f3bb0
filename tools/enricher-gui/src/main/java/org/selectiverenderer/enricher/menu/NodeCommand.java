package org.selectiverenderer.enricher.menu;

import java.util.function.Consumer;
import java.util.function.Predicate;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A command of a node's context menu.
 *
 * @param id the component name of the menu item, for tests
 * @param title the text of the menu item, with {@code &} before its mnemonic letter
 * @param key the key of the command in the tree, as {@code KeyStroke} reads it; empty for none
 * @param fits whether the command is enabled for a node
 * @param work executes the command
 */
public record NodeCommand(
    String id,
    String title,
    String key,
    Predicate<DocumentElement> fits,
    Consumer<DocumentElement> work) {
  /** Creates a command without a key. */
  public NodeCommand(
      String id, String title, Predicate<DocumentElement> fits, Consumer<DocumentElement> work) {
    this(id, title, "", fits, work);
  }
}
