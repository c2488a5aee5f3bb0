package org.selectiverenderer.browser.sai;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.web3d.x3d.sai.InvalidFieldException;
import org.web3d.x3d.sai.X3DFieldDefinition;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DNodeTypes;
import org.web3d.x3d.sai.X3DProtoInstance;

/**
 * The data that the SAI objects of all nodes of one type share: interfaces, type constants, field
 * definitions, and the meaning of each method. Thread-safe.
 */
final class NodeTypeInfo {
  private final NodeType type;
  private final ProxyMaker proxies;
  private final int[] numbers;
  private final EmbeddedFieldDefinition[] definitions;
  private final Map<Method, NodeMethod> methods = new ConcurrentHashMap<>();

  /** The definitions by every name that was asked for and that a field has. */
  private final Map<String, EmbeddedFieldDefinition> byName = new ConcurrentHashMap<>();

  NodeTypeInfo(NodeType type, SaiTypeRegistry types) {
    this.type = type;
    proxies = new ProxyMaker(interfacesOf(type));
    numbers =
        type.ancestors().stream()
            .sorted()
            .map(name -> name.equals("X3DPrototypeInstance") ? "X3DProtoInstance" : name)
            .flatMap(name -> SaiTypeRegistry.constant(X3DNodeTypes.class, name).stream())
            .mapToInt(Integer::intValue)
            .toArray();
    definitions =
        type.fields().stream().map(types::describe).toArray(EmbeddedFieldDefinition[]::new);
  }

  private static Class<?>[] interfacesOf(NodeType type) {
    List<Class<?>> all = new ArrayList<>();
    all.add(X3DNode.class);
    List<String> names = new ArrayList<>();
    if (type.isPrototype()) {
      all.add(X3DProtoInstance.class);
    } else {
      names.add(type.component().toLowerCase(Locale.ROOT) + "." + type.name());
    }
    type.ancestors().stream().sorted().forEach(names::add);
    names.forEach(name -> SaiTypeRegistry.find(name).ifPresent(all::add));
    return all.stream().distinct().filter(one -> needed(one, all)).toArray(Class<?>[]::new);
  }

  /**
   * Returns whether a proxy must name an interface: X3DNode, whose methods are known as its own,
   * and those that no other one extends. The JVM makes the class of a proxy from the methods of all
   * that are named, which a start waits for.
   */
  private static boolean needed(Class<?> one, List<Class<?>> all) {
    return one == X3DNode.class
        || all.stream().noneMatch(other -> other != one && one.isAssignableFrom(other));
  }

  /**
   * Makes the SAI object of a node. It implements X3DNode and the interfaces of the type itself and
   * of its abstract types, as far as none of them extends the other.
   */
  X3DNode proxy(InvocationHandler handler) {
    return (X3DNode) proxies.make(handler);
  }

  /** Returns the constants of its abstract types. */
  int[] numbers() {
    return numbers.clone();
  }

  X3DFieldDefinition[] definitions() {
    X3DFieldDefinition[] all = new X3DFieldDefinition[definitions.length];
    System.arraycopy(definitions, 0, all, 0, all.length);
    return all;
  }

  EmbeddedFieldDefinition definition(FieldDefinition field) {
    return definitions[field.index()];
  }

  /**
   * Returns a field's definition by the field's name or that of its events.
   *
   * @throws InvalidFieldException if there is no such field
   */
  EmbeddedFieldDefinition definition(String name) {
    EmbeddedFieldDefinition known = byName.get(name);
    if (known == null) {
      known = find(name);
      byName.put(name, known);
    }
    return known;
  }

  private EmbeddedFieldDefinition find(String name) {
    return type.field(name)
        .or(() -> type.input(name))
        .or(() -> type.output(name))
        .map(this::definition)
        .orElseThrow(() -> new InvalidFieldException(type.name() + " has no field " + name));
  }

  NodeMethod meaning(Method method) {
    NodeMethod known = methods.get(method);
    return known != null
        ? known
        : methods.computeIfAbsent(method, missing -> NodeMethod.of(missing, type));
  }
}
