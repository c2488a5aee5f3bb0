package org.selectiverenderer.authoring.enrichment;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.schema.SchemaField;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/**
 * Changes a MetadataSet string by string: strings that already have the wanted values stay, as does
 * other metadata. Several values are written in one MetadataString, unless the author has given
 * each its own (thesis Fig 47).
 */
final class MetadataSetWriter {
  private final SceneDocument document;
  private final SourceFormatter layout;
  private final MetadataXmlWriter text;
  private final SharedMetadataGuard sharing;

  MetadataSetWriter(SceneDocument document, MetadataXmlWriter text) {
    this.document = document;
    this.layout = document.layout();
    this.text = text;
    this.sharing = new SharedMetadataGuard(document);
  }

  /**
   * @param about the name from which the DEF names of new strings are made
   * @param wanted the values of the fields to change; an empty list clears a field
   */
  List<TextEdit> changes(MetadataElement set, String about, Map<SchemaField, List<String>> wanted) {
    List<TextEdit> changes = new ArrayList<>();
    List<DocumentElement> removed = new ArrayList<>();
    List<String> lines = new ArrayList<>();
    wanted.forEach(
        (field, values) -> {
          List<MetadataElement> strings = new ArrayList<>();
          collect(set, field, strings);
          lines.addAll(field(strings, field, about, values, changes, removed));
        });
    removed.forEach(sharing::free);
    if (lines.isEmpty()) {
      removed.forEach(element -> changes.add(layout.remove(element)));
      return changes;
    }
    DocumentElement owner = set.meant();
    sharing.extensible(owner);
    Optional<DocumentElement> anchor =
        owner.children().stream().filter(child -> !removed.contains(child)).reduce((a, b) -> b);
    int first = 0;
    if (anchor.isPresent()) {
      changes.add(layout.insertAfter(anchor.get(), lines));
    } else if (!removed.isEmpty()) {
      changes.add(layout.replace(removed.get(0), lines));
      first = 1;
    } else {
      changes.add(layout.insertLast(owner, lines));
    }
    removed.stream().skip(first).forEach(element -> changes.add(layout.remove(element)));
    return changes;
  }

  private static void collect(
      MetadataElement in, SchemaField field, List<MetadataElement> strings) {
    for (MetadataElement child : in.children()) {
      if (child.isSet() && !child.shared()) {
        collect(child, field, strings);
      } else if (SchemaField.of(child.name()).filter(field::equals).isPresent()) {
        strings.add(child);
      }
    }
  }

  /** Changes the strings of a field and returns the lines of new strings. */
  private List<String> field(
      List<MetadataElement> strings,
      SchemaField field,
      String about,
      List<String> wanted,
      List<TextEdit> changes,
      List<DocumentElement> removed) {
    List<MetadataElement> own = strings.stream().filter(string -> !string.shared()).toList();
    strings.stream().filter(MetadataElement::shared).forEach(s -> removed.add(s.written()));
    if (wanted.isEmpty() || own.isEmpty()) {
      own.forEach(string -> removed.add(string.written()));
      return text.string(field, about, wanted);
    }
    List<List<String>> spread = spread(own, wanted);
    for (int i = 0; i < own.size(); i++) {
      DocumentElement element = own.get(i).written();
      if (spread.get(i).isEmpty()) {
        removed.add(element);
      } else if (!spread.get(i).equals(stripped(own.get(i).values()))) {
        sharing.free(element);
        changes.add(layout.attribute(element, "value", FieldValueFormatter.strings(spread.get(i))));
      }
    }
    List<String> lines = new ArrayList<>();
    for (List<String> more : spread.subList(own.size(), spread.size())) {
      lines.addAll(text.string(field, about, more));
    }
    return lines;
  }

  /**
   * Distributes the wanted values over the existing strings; further lists are new strings. Where
   * each value had a string of its own, this is kept if it preserves the order of the values.
   */
  private static List<List<String>> spread(List<MetadataElement> strings, List<String> wanted) {
    List<List<String>> spread = new ArrayList<>();
    if (strings.size() > 1) {
      List<String> rest = new ArrayList<>(wanted);
      List<String> order = new ArrayList<>();
      for (MetadataElement string : strings) {
        List<String> kept = new ArrayList<>(stripped(string.values()));
        kept.retainAll(rest);
        rest.removeAll(kept);
        order.addAll(kept);
        spread.add(kept);
      }
      order.addAll(rest);
      rest.forEach(value -> spread.add(List.of(value)));
      if (order.equals(wanted)) {
        return spread;
      }
      spread.clear();
    }
    spread.add(wanted);
    while (spread.size() < strings.size()) {
      spread.add(List.of());
    }
    return spread;
  }

  private static List<String> stripped(List<String> values) {
    return values.stream().map(String::strip).filter(value -> !value.isEmpty()).toList();
  }
}
