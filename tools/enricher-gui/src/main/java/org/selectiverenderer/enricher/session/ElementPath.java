package org.selectiverenderer.enricher.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * The path of an element, to find it again in a tree that was parsed again: by its DEF name if it
 * has one, else by its indices among its siblings.
 *
 * @param name the element's name
 * @param places child indices from the root down
 */
public record ElementPath(String name, Optional<String> def, List<Integer> places) {
  public static ElementPath of(DocumentElement element) {
    List<Integer> places = new ArrayList<>();
    DocumentElement at = element;
    while (at.parent().isPresent()) {
      DocumentElement parent = at.parent().get();
      places.add(parent.children().indexOf(at));
      at = parent;
    }
    Collections.reverse(places);
    return new ElementPath(element.name(), element.def(), List.copyOf(places));
  }

  public Optional<DocumentElement> find(ElementTree tree) {
    Optional<DocumentElement> named = def.flatMap(tree::named);
    if (named.isPresent()) {
      return named;
    }
    DocumentElement at = tree.root();
    for (int place : places) {
      if (place < 0 || place >= at.children().size()) {
        return Optional.empty();
      }
      at = at.children().get(place);
    }
    return Optional.of(at).filter(found -> found.name().equals(name));
  }
}
