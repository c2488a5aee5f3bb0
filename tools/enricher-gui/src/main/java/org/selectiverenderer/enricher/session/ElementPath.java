package org.selectiverenderer.enricher.session;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.ElementTree;

/**
 * The path of an element, to find it again in a tree that was parsed again: by its DEF name, in the
 * scope of that name, if it has one, else by its indices among its siblings.
 *
 * @param name the element's name
 * @param places child indices from the root down
 * @param scope the number of those indices that lead to the declaration of the prototype that the
 *     element is part of; 0 for an element of the scene
 */
public record ElementPath(String name, Optional<String> def, List<Integer> places, int scope) {
  public static ElementPath of(DocumentElement element) {
    return new ElementPath(
        element.name(), element.def(), places(element), places(ElementScope.of(element)).size());
  }

  private static List<Integer> places(DocumentElement element) {
    List<Integer> places = new ArrayList<>();
    DocumentElement at = element;
    while (at.parent().isPresent()) {
      DocumentElement parent = at.parent().get();
      places.add(parent.children().indexOf(at));
      at = parent;
    }
    Collections.reverse(places);
    return List.copyOf(places);
  }

  public Optional<DocumentElement> find(ElementTree tree) {
    Optional<DocumentElement> named =
        def.flatMap(
            given ->
                at(tree, scope)
                    .flatMap(bound -> bound.children().stream().findFirst())
                    .flatMap(inside -> tree.named(given, inside)));
    return named.or(() -> at(tree, places.size()).filter(found -> found.name().equals(name)));
  }

  /** Returns the element that the first places lead to. */
  private Optional<DocumentElement> at(ElementTree tree, int count) {
    DocumentElement at = tree.root();
    for (int place : places.subList(0, count)) {
      if (place < 0 || place >= at.children().size()) {
        return Optional.empty();
      }
      at = at.children().get(place);
    }
    return Optional.of(at);
  }
}
