package org.selectiverenderer.document.versions;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.document.FreeNames;
import org.selectiverenderer.document.Layout;
import org.selectiverenderer.document.XmlValues;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextChange;
import org.selectiverenderer.x3d.write.ValueText;

/**
 * Creates the text changes that put versions into a scene: a Switch for a new object, else more or
 * fewer Inlines.
 */
final class SceneEdit {
  private final SceneSource scene;
  private final ObjectElement site;
  private final Layout layout;
  private final FreeNames names;
  private final Set<String> renamed;

  /**
   * @param renamed the URLs of versions whose file names change
   */
  SceneEdit(SceneSource scene, ObjectElement site, Collection<String> renamed) {
    this.renamed = Set.copyOf(renamed);
    this.scene = scene;
    this.site = site;
    this.layout = scene.snapshot().layout();
    this.names = new FreeNames(scene.elements());
  }

  /**
   * Returns the changes.
   *
   * @param urls URLs of the versions, the original first
   */
  List<TextChange> changes(List<String> urls) {
    return site instanceof ObjectElement.Versioned versioned
        ? changes(versioned.inlines(), urls)
        : changes(((ObjectElement.Whole) site), urls);
  }

  private List<TextChange> changes(ObjectElement.Whole whole, List<String> urls) {
    DocumentElement first = whole.elements().get(0);
    String choice = names.unused("Switch_" + site.name());
    List<String> inlines = new ArrayList<>();
    for (int i = 1; i <= urls.size(); i++) {
      inlines.add(names.unused("Inline_" + site.name() + "_v" + i));
    }
    List<TextChange> changes = new ArrayList<>();
    if (layout.onItsOwnLine(first)) {
      List<String> lines =
          VersionSwitch.lines(choice, inlines, urls, layout.quote(first), layout.step(first));
      changes.add(layout.replace(first, lines));
    } else {
      SharedLine shared = new SharedLine(scene.snapshot(), first);
      List<String> lines =
          VersionSwitch.lines(choice, inlines, urls, shared.quote(), shared.step());
      changes.add(shared.replace(lines));
    }
    whole.elements().stream().skip(1).map(layout::remove).forEach(changes::add);
    return changes;
  }

  private List<TextChange> changes(List<DocumentElement> inlines, List<String> urls) {
    DocumentElement last = inlines.get(inlines.size() - 1);
    List<String> lines = new ArrayList<>();
    for (int number = inlines.size() + 1; number <= urls.size(); number++) {
      lines.add(further(last, inlines.size(), number, urls.get(number - 1)));
    }
    List<TextChange> changes = new ArrayList<>();
    for (int i = 0; i < Math.min(inlines.size(), urls.size()); i++) {
      named(inlines.get(i), urls.get(i)).ifPresent(changes::add);
    }
    if (!lines.isEmpty()) {
      changes.add(layout.insertAfter(last, lines));
    }
    inlines.stream().skip(urls.size()).map(layout::remove).forEach(changes::add);
    return changes;
  }

  /** Changes the first URL of an Inline; its further URLs stay. */
  private Optional<TextChange> named(DocumentElement inline, String url) {
    if (!renamed.contains(url)) {
      return Optional.empty();
    }
    if (inline.use().isPresent()) {
      String name = names.unused("Inline_" + site.name());
      return Optional.of(
          layout.replace(inline, List.of(VersionSwitch.inline(name, url, layout.quote(inline)))));
    }
    List<String> all = new ArrayList<>(XmlValues.strings(inline.text("url").orElse("")));
    if (all.isEmpty()) {
      all.add(url);
    } else {
      all.set(0, url);
    }
    return Optional.of(layout.attribute(inline, "url", ValueText.strings(all)));
  }

  private String further(DocumentElement last, int had, int number, String url) {
    String name = last.def().orElse("Inline_" + site.name());
    String ending = "_v" + had;
    String base = name.endsWith(ending) ? name.substring(0, name.length() - ending.length()) : name;
    String free = names.unused(base + "_v" + number);
    return last.use().isPresent()
        ? VersionSwitch.inline(free, url, layout.quote(last))
        : VersionSwitch.further(
            scene.snapshot().text().substring(last.start(), last.tagEnd()), had, number, free);
  }
}
