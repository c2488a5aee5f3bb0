package org.selectiverenderer.polygon.versions;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.selectiverenderer.x3d.SceneElement;

/** Puts versions into a scene's text: a Switch for a new object, else more or fewer Inlines. */
final class SceneEdit {
  private final SceneSource scene;
  private final ObjectSite site;

  SceneEdit(SceneSource scene, ObjectSite site) {
    this.scene = scene;
    this.site = site;
  }

  /**
   * The change.
   *
   * @param urls of the versions, the original first
   */
  TextEdits edits(List<String> urls) {
    TextEdits edits = new TextEdits(scene.text());
    if (site instanceof ObjectSite.Whole whole) {
      SceneElement first = whole.elements().get(0);
      List<String> names = new ArrayList<>();
      for (int i = 1; i <= urls.size(); i++) {
        names.add(free("Inline_" + site.name() + "_v" + i));
      }
      edits.replace(
          first,
          SwitchText.lines(
              free("Switch_" + site.name()), names, urls, edits.quote(), edits.step(first)));
      whole.elements().stream().skip(1).forEach(edits::remove);
      return edits;
    }
    List<SceneElement> inlines = ((ObjectSite.Versioned) site).inlines();
    int had = inlines.size();
    SceneElement last = inlines.get(had - 1);
    if (urls.size() > had) {
      edits.insertAfter(
          last,
          IntStream.rangeClosed(had + 1, urls.size())
              .mapToObj(
                  number ->
                      SwitchText.further(
                          edits,
                          last,
                          had,
                          number,
                          further(last, had, number),
                          urls.get(number - 1)))
              .toList());
    }
    inlines.stream().skip(urls.size()).forEach(edits::remove);
    return edits;
  }

  private String further(SceneElement last, int had, int number) {
    String name = last.attribute("DEF").orElse("Inline_" + site.name());
    String ending = "_v" + had;
    String base = name.endsWith(ending) ? name.substring(0, name.length() - ending.length()) : name;
    return free(base + "_v" + number);
  }

  /** A name that no node has. */
  private String free(String name) {
    Set<String> taken = new HashSet<>();
    scene.text().root().visit(element -> element.attribute("DEF").ifPresent(taken::add));
    String free = name;
    for (int i = 2; taken.contains(free); i++) {
      free = name + "_" + i;
    }
    return free;
  }
}
