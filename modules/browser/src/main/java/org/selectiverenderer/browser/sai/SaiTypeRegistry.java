package org.selectiverenderer.browser.sai;

import java.lang.reflect.InvocationHandler;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.field.FieldType;
import org.web3d.x3d.sai.MField;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DNode;

/**
 * Finds and caches the SAI's interfaces and constants for the types of the node catalogue, by name.
 * Thread-safe.
 */
final class SaiTypeRegistry {
  private static final String PACKAGE = X3DNode.class.getPackageName() + ".";

  private final Map<NodeType, NodeTypeInfo> kinds = new ConcurrentHashMap<>();
  private final Map<FieldType, ProxyMaker> fieldProxies = new ConcurrentHashMap<>();
  private final Map<FieldType, Integer> fieldNumbers = new ConcurrentHashMap<>();

  NodeTypeInfo kind(NodeType type) {
    if (type.ownFrom() < type.fields().size()) {
      return new NodeTypeInfo(type, this); // The type of one node alone: not cached.
    }
    NodeTypeInfo known = kinds.get(type);
    return known != null
        ? known
        : kinds.computeIfAbsent(type, missing -> new NodeTypeInfo(missing, this));
  }

  /**
   * Makes the SAI object of a field. It implements the interface of the field's type or, of types
   * that the SAI lacks (SFVec4f ...), the general one.
   */
  X3DField proxy(FieldType type, InvocationHandler handler) {
    ProxyMaker maker = fieldProxies.get(type);
    if (maker == null) {
      maker = fieldProxies.computeIfAbsent(type, missing -> new ProxyMaker(interfaceOf(missing)));
    }
    return (X3DField) maker.make(handler);
  }

  private static Class<?> interfaceOf(FieldType type) {
    return find(type.name()).orElse(type.multiple() ? MField.class : X3DField.class);
  }

  EmbeddedFieldDefinition describe(FieldDefinition field) {
    int number =
        fieldNumbers.computeIfAbsent(
            field.type(),
            type -> constant(X3DFieldTypes.class, type.name().toUpperCase(Locale.ROOT)).orElse(0));
    return new EmbeddedFieldDefinition(field, number);
  }

  /** Returns an interface of the SAI by its name below the base package. */
  static Optional<Class<?>> find(String name) {
    try {
      return Optional.of(Class.forName(PACKAGE + name, false, X3DNode.class.getClassLoader()));
    } catch (ClassNotFoundException e) {
      return Optional.empty();
    }
  }

  /** Returns a constant of the SAI; empty if it has none of that name. */
  static Optional<Integer> constant(Class<?> holder, String name) {
    try {
      return Optional.of(holder.getField(name).getInt(null));
    } catch (NoSuchFieldException | IllegalAccessException e) {
      return Optional.empty();
    }
  }
}
