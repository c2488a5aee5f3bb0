package org.selectiverenderer.enricher.menu;

import java.util.function.Consumer;
import java.util.function.Predicate;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Something that can be done with a node.
 *
 * @param id names it for tests
 * @param title as the menu shows it; {@code &} before the letter that chooses it
 * @param fits whether it can be done with that node now; greyed where not
 * @param work does it
 */
public record NodeCommand(
    String id, String title, Predicate<DocumentElement> fits, Consumer<DocumentElement> work) {}
