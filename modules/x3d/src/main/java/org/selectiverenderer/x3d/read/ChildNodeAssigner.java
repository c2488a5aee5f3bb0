package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.x3d.catalogue.ContainerFieldRules;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;

/** Assigns the child nodes of a node to its fields (containerField, ISO/IEC 19776-1, 4.3.6). */
final class ChildNodeAssigner {
  private final ParsedNode parent;
  private final ReadContext reading;
  // few fields of a node are lists, so that linear search is faster than hashing
  private final List<FieldDefinition> fields = new ArrayList<>(2);
  private final List<List<ParsedNode>> lists = new ArrayList<>(2);
  private final Map<FieldDefinition, Integer> connected = new IdentityHashMap<>(0);

  ChildNodeAssigner(ParsedNode parent, ReadContext reading) {
    this.parent = parent;
    this.reading = reading;
  }

  /**
   * Assigns a child to the field named by its containerField, or else to one that accepts its type.
   *
   * @param containerField the value in the file, or null
   */
  void add(ParsedNode child, @Nullable String containerField, SourceLocation location) {
    FieldDefinition field = wanted(child.type(), containerField);
    if (field == null) {
      field = fitting(child.type());
      if (field == null) {
        reading.error(
            location,
            one(child.type()) + " is not allowed in " + one(parent.type()) + "; it is left out");
        return;
      }
      reading.warning(
          location,
          one(child.type())
              + " does not fit into "
              + (containerField == null ? child.type().containerField() : containerField)
              + " of "
              + one(parent.type())
              + "; it is used as its "
              + field.name());
    }
    put(field, child, location);
  }

  /**
   * Assigns a node that IS gives to a field that accepts its type. These precede all others of the
   * field, as the encodings have IS in different places.
   */
  void connect(FieldDefinition field, ParsedNode child, SourceLocation location) {
    if (field.type().multiple()) {
      int before = connected.merge(field, 1, Integer::sum) - 1;
      list(field).add(before, child);
    } else {
      put(field, child, location);
    }
  }

  private void put(FieldDefinition field, ParsedNode child, SourceLocation location) {
    if (field.type().multiple()) {
      list(field).add(child);
    } else if (parent.given(field.index())) {
      reading.error(
          location,
          "the "
              + field.name()
              + " of "
              + one(parent.type())
              + " can be only one node, and there is one already; this "
              + child.type()
              + " is left out");
    } else {
      parent.put(field.index(), child);
    }
  }

  private static String one(NodeType type) {
    return SpellingSuggester.one(type.name());
  }

  /** Sets the lists of nodes as values of the parent. */
  void finish() {
    for (int i = 0; i < lists.size(); i++) {
      parent.put(fields.get(i).index(), List.copyOf(lists.get(i)));
    }
  }

  private List<ParsedNode> list(FieldDefinition field) {
    for (int i = 0; i < lists.size(); i++) {
      if (fields.get(i) == field) {
        return lists.get(i);
      }
    }
    List<ParsedNode> list = new ArrayList<>(4);
    fields.add(field);
    lists.add(list);
    return list;
  }

  private @Nullable FieldDefinition wanted(NodeType child, @Nullable String containerField) {
    return ContainerFieldRules.wanted(parent.type(), child, containerField).orElse(null);
  }

  private @Nullable FieldDefinition fitting(NodeType child) {
    FieldDefinition usual = parent.type().field(child.containerField()).orElse(null);
    if (usual != null && ContainerFieldRules.accepts(usual, child)) {
      return usual;
    }
    FieldDefinition taken = null;
    for (FieldDefinition field : parent.type().fields()) {
      if (ContainerFieldRules.accepts(field, child)) {
        if (field.type().multiple() || !parent.given(field.index())) {
          return field;
        }
        taken = field;
      }
    }
    return taken;
  }
}
