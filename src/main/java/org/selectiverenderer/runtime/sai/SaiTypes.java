package org.selectiverenderer.runtime.sai;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.selectiverenderer.x3d.FieldType;
import org.selectiverenderer.x3d.NodeType;
import org.web3d.x3d.sai.X3DFieldTypes;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DNodeTypes;

/** Finds the SAI's interfaces and constants for the types of the catalogue, by their names. */
final class SaiTypes {
  private static final String PACKAGE = X3DNode.class.getPackageName() + ".";

  private final Map<NodeType, Class<?>[]> interfaces = new ConcurrentHashMap<>();
  private final Map<String, Optional<Class<?>>> found = new ConcurrentHashMap<>();

  /**
   * The interfaces of a node: X3DNode, its own, and those of the abstract types it descends from.
   */
  Class<?>[] interfacesOf(NodeType type) {
    return interfaces.computeIfAbsent(type, this::collect);
  }

  private Class<?>[] collect(NodeType type) {
    List<Class<?>> all = new ArrayList<>();
    all.add(X3DNode.class);
    find(type.component().toLowerCase(Locale.ROOT) + "." + type.name()).ifPresent(all::add);
    type.ancestors().stream().sorted().forEach(name -> find(name).ifPresent(all::add));
    return all.stream().distinct().toArray(Class<?>[]::new);
  }

  /** An interface of the SAI by its name below the base package. */
  Optional<Class<?>> find(String name) {
    return found.computeIfAbsent(name, SaiTypes::load);
  }

  private static Optional<Class<?>> load(String name) {
    try {
      return Optional.of(Class.forName(PACKAGE + name, false, X3DNode.class.getClassLoader()));
    } catch (ClassNotFoundException e) {
      return Optional.empty();
    }
  }

  /** The constants of the abstract types of a node. */
  static int[] nodeTypes(NodeType type) {
    return type.ancestors().stream()
        .sorted()
        .flatMap(name -> constant(X3DNodeTypes.class, name).stream())
        .mapToInt(Integer::intValue)
        .toArray();
  }

  /** The constant of a field type; 0 for one that the SAI does not number (SFVec4f ...). */
  static int fieldType(FieldType type) {
    return constant(X3DFieldTypes.class, type.name().toUpperCase(Locale.ROOT)).orElse(0);
  }

  private static Optional<Integer> constant(Class<?> holder, String name) {
    try {
      Field field = holder.getField(name);
      return Optional.of(field.getInt(null));
    } catch (NoSuchFieldException | IllegalAccessException e) {
      return Optional.empty();
    }
  }
}
