package org.selectiverenderer.authoring.versions;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.MFStringParser;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.structure.NeededComponents;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Creates the text changes that put versions into a scene: a Switch for a new object, else more or
 * fewer Inlines.
 */
final class VersionSwitchEdit {
  private final ElementNodeMapping scene;
  private final ObjectElements site;
  private final SourceFormatter layout;
  private final UniqueNameGenerator names;
  private final Set<String> renamed;
  private final NeededComponents components;

  /**
   * @param renamed the URLs of versions whose file names change
   */
  VersionSwitchEdit(
      ElementNodeMapping scene,
      ObjectElements site,
      Collection<String> renamed,
      NodeCatalogue catalogue) {
    this.renamed = Set.copyOf(renamed);
    this.scene = scene;
    this.site = site;
    this.layout = scene.snapshot().layout();
    this.names = new UniqueNameGenerator(scene.elements());
    this.components = new NeededComponents(scene.snapshot(), scene.elements(), catalogue);
  }

  /**
   * Returns the changes.
   *
   * @param urls URLs of the versions, the original first
   */
  List<TextEdit> changes(List<String> urls) {
    return site instanceof ObjectElements.Versioned versioned
        ? changes(versioned.inlines(), urls)
        : changes(((ObjectElements.Whole) site), urls);
  }

  private List<TextEdit> changes(ObjectElements.Whole whole, List<String> urls) {
    DocumentElement first = whole.elements().get(0);
    String choice =
        whole
            .choice()
            .map(around -> around.def().orElse(""))
            .orElseGet(() -> names.unused("Switch_" + site.name()));
    List<String> inlines = new ArrayList<>();
    for (int i = 1; i <= urls.size(); i++) {
      inlines.add(names.unused("Inline_" + site.name() + "_v" + i));
    }
    List<TextEdit> changes = new ArrayList<>();
    if (whole.choice().isPresent()) {
      char quote = layout.quote(first);
      List<String> lines = new ArrayList<>();
      for (int i = 0; i < urls.size(); i++) {
        lines.add(VersionSwitchWriter.inline(inlines.get(i), urls.get(i), quote));
      }
      changes.add(layout.replace(first, lines));
    } else if (layout.onItsOwnLine(first)) {
      List<String> lines =
          VersionSwitchWriter.lines(choice, inlines, urls, layout.quote(first), layout.step(first));
      changes.add(layout.replace(first, lines));
    } else {
      SharedLineFormatter shared = new SharedLineFormatter(scene.snapshot(), first);
      List<String> lines =
          VersionSwitchWriter.lines(choice, inlines, urls, shared.quote(), shared.step());
      changes.add(shared.replace(lines));
    }
    changes.addAll(components.of(Set.of("Switch", "Inline")));
    whole.elements().stream().skip(1).map(layout::remove).forEach(changes::add);
    changes.addAll(new SharedNodes(scene, whole.elements()).changes(choice));
    return changes;
  }

  private List<TextEdit> changes(List<DocumentElement> inlines, List<String> urls) {
    DocumentElement last = inlines.get(inlines.size() - 1);
    List<String> lines = new ArrayList<>();
    for (int number = inlines.size() + 1; number <= urls.size(); number++) {
      lines.add(further(last, inlines.size(), number, urls.get(number - 1)));
    }
    List<TextEdit> changes = new ArrayList<>();
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
  private Optional<TextEdit> named(DocumentElement inline, String url) {
    if (!renamed.contains(url)) {
      return Optional.empty();
    }
    if (inline.use().isPresent()) {
      String name = names.unused("Inline_" + site.name());
      return Optional.of(
          layout.replace(
              inline, List.of(VersionSwitchWriter.inline(name, url, layout.quote(inline)))));
    }
    List<String> all = new ArrayList<>(MFStringParser.strings(inline.text("url").orElse("")));
    if (all.isEmpty()) {
      all.add(url);
    } else {
      all.set(0, url);
    }
    return Optional.of(layout.attribute(inline, "url", FieldValueFormatter.strings(all)));
  }

  private String further(DocumentElement last, int had, int number, String url) {
    String name = last.def().orElse("Inline_" + site.name());
    String ending = "_v" + had;
    String base = name.endsWith(ending) ? name.substring(0, name.length() - ending.length()) : name;
    String free = names.unused(base + "_v" + number);
    return last.use().isPresent()
        ? VersionSwitchWriter.inline(free, url, layout.quote(last))
        : VersionSwitchWriter.further(
            scene.snapshot().text().substring(last.start(), last.tagEnd()), had, number, free);
  }

  /**
   * Formats a Switch that replaces an element that shares its line with others: the Switch begins
   * where the element began and continues on lines of its own, so that the versions can be read.
   */
  private static final class SharedLineFormatter {
    private final String text;
    private final DocumentElement element;
    private final String indentation;

    SharedLineFormatter(DocumentSnapshot scene, DocumentElement element) {
      this.text = scene.text();
      this.element = element;
      this.indentation = scene.layout().indentation(element);
    }

    /** Returns one step of indentation. */
    String step() {
      return indentation.contains("\t") ? "\t" : "  ";
    }

    /** Returns the quote character that the scene uses first. */
    char quote() {
      int single = text.indexOf("='");
      int twice = text.indexOf("=\"", Math.max(0, text.indexOf("?>")));
      return single < 0 || twice >= 0 && twice < single ? '"' : '\'';
    }

    /** Replaces the element by lines. */
    TextEdit replace(List<String> lines) {
      String separator = endOfLine() + indentation;
      return new TextEdit(element.start(), element.end(), String.join(separator, lines));
    }

    /** Returns the line end of the scene's first line. */
    private String endOfLine() {
      int feed = text.indexOf('\n');
      if (feed < 0) {
        return text.indexOf('\r') < 0 ? "\n" : "\r";
      }
      return feed > 0 && text.charAt(feed - 1) == '\r' ? "\r\n" : "\n";
    }
  }
}
