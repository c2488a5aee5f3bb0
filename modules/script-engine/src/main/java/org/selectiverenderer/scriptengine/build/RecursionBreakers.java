package org.selectiverenderer.scriptengine.build;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * Chooses the methods whose entry is metered: so many that without them no method of Rhino can call
 * itself, directly or through others. All other work is in loops, which are metered, or bounded.
 *
 * <p>A virtual call is taken to reach every method of that name and descriptor, a lambda to be
 * called where it is made and wherever its interface is. The interpreter is left out, as it counts
 * instructions and each nested run of it is metered. Methods that the JDK may call, such as {@code
 * equals} of a key, are always metered.
 */
final class RecursionBreakers {
  private static final Set<String> CALLED_BY_THE_JDK =
      Set.of(
          "equals",
          "hashCode",
          "compare",
          "compareTo",
          "apply",
          "accept",
          "test",
          "run",
          "next",
          "hasNext",
          "iterator",
          "toString");

  private final Map<String, Set<String>> calls = new TreeMap<>();
  private final Map<String, Set<String>> bySignature = new HashMap<>();
  private final Set<String> chosen = new HashSet<>();

  /** Reads a class of Rhino. */
  void add(byte[] type) {
    ClassReader reader = new ClassReader(type);
    String owner = reader.getClassName();
    if (owner.startsWith("org/mozilla/javascript/Interpreter")) {
      return;
    }
    reader.accept(
        new ClassVisitor(Opcodes.ASM9) {
          @Override
          public @Nullable MethodVisitor visitMethod(
              int access,
              String name,
              String descriptor,
              @Nullable String signature,
              String @Nullable [] exceptions) {
            if (name.equals("$deserializeLambda$")) {
              return null;
            }
            String method = owner + "." + name + descriptor;
            bySignature.computeIfAbsent(name + descriptor, k -> new TreeSet<>()).add(method);
            if (CALLED_BY_THE_JDK.contains(name)) {
              chosen.add(method);
            }
            return new Calls(calls.computeIfAbsent(method, k -> new TreeSet<>()));
          }
        },
        ClassReader.SKIP_DEBUG | ClassReader.SKIP_FRAMES);
  }

  /** Collects what a method calls: methods, or names and descriptors of virtual ones. */
  private final class Calls extends MethodVisitor {
    private final Set<String> called;

    Calls(Set<String> called) {
      super(Opcodes.ASM9);
      this.called = called;
    }

    @Override
    public void visitMethodInsn(
        int opcode, String type, String name, String descriptor, boolean ofInterface) {
      boolean exact = opcode == Opcodes.INVOKESTATIC || opcode == Opcodes.INVOKESPECIAL;
      called.add(exact ? type + "." + name + descriptor : name + descriptor);
    }

    @Override
    public void visitInvokeDynamicInsn(
        String name, String descriptor, Handle bootstrap, Object... arguments) {
      for (Object argument : arguments) {
        if (argument instanceof Handle made) {
          String method = made.getOwner() + "." + made.getName() + made.getDesc();
          called.add(method);
          String of = name + arguments[0];
          bySignature.computeIfAbsent(of, k -> new TreeSet<>()).add(method);
        }
      }
    }
  }

  /** Returns the methods, each as owner, dot, name and descriptor. */
  Set<String> choose() {
    Map<String, List<String>> edges = new TreeMap<>();
    calls.forEach(
        (method, called) -> {
          Set<String> targets = new TreeSet<>();
          for (String one : called) {
            if (calls.containsKey(one)) {
              targets.add(one);
            } else {
              // Virtual, or exact to a class that inherits the method.
              String signature =
                  one.substring(one.indexOf('.', one.lastIndexOf('/', end(one))) + 1);
              targets.addAll(bySignature.getOrDefault(signature, Set.of()));
            }
          }
          targets.retainAll(calls.keySet());
          edges.put(method, new ArrayList<>(targets));
        });
    chosen.forEach(edges::remove);
    Deque<Collection<String>> parts = new ArrayDeque<>();
    parts.add(edges.keySet());
    while (!parts.isEmpty()) {
      for (Set<String> cycle : new Components(edges, parts.pop()).cycles()) {
        String most = busiest(edges, cycle);
        chosen.add(most);
        cycle.remove(most);
        parts.add(cycle);
      }
    }
    return chosen;
  }

  private static int end(String method) {
    int end = method.indexOf('(');
    return end < 0 ? method.length() : end;
  }

  /** Returns the method of a cycle with the most ways through it. */
  private static String busiest(Map<String, List<String>> edges, Set<String> cycle) {
    Map<String, Integer> in = new HashMap<>();
    Map<String, Integer> out = new HashMap<>();
    for (String from : cycle) {
      for (String to : edges.getOrDefault(from, List.of())) {
        if (cycle.contains(to)) {
          out.merge(from, 1, Integer::sum);
          in.merge(to, 1, Integer::sum);
        }
      }
    }
    String best = cycle.iterator().next();
    long most = -1;
    for (String method : new TreeSet<>(cycle)) {
      long ways = (long) in.getOrDefault(method, 0) * out.getOrDefault(method, 0);
      if (ways > most) {
        most = ways;
        best = method;
      }
    }
    return best;
  }

  /** The strongly connected components of a part of a graph, by Tarjan's algorithm. */
  private static final class Components {
    private final Map<String, List<String>> edges;
    private final Set<String> part;
    private final Map<String, Integer> index = new HashMap<>();
    private final Map<String, Integer> low = new HashMap<>();
    private final Deque<String> stack = new ArrayDeque<>();
    private final Set<String> onStack = new HashSet<>();
    private final List<Set<String>> cycles = new ArrayList<>();

    Components(Map<String, List<String>> edges, Collection<String> part) {
      this.edges = edges;
      this.part = new TreeSet<>(part);
      for (String method : this.part) {
        if (!index.containsKey(method)) {
          visit(method);
        }
      }
    }

    /** Returns the components in which a method can reach itself. */
    List<Set<String>> cycles() {
      return cycles;
    }

    private void visit(String method) {
      int at = index.size();
      index.put(method, at);
      low.put(method, at);
      stack.push(method);
      onStack.add(method);
      for (String to : edges.getOrDefault(method, List.of())) {
        if (!part.contains(to)) {
          continue;
        }
        if (!index.containsKey(to)) {
          visit(to);
          low.merge(method, low.get(to), Math::min);
        } else if (onStack.contains(to)) {
          low.merge(method, index.get(to), Math::min);
        }
      }
      if (low.get(method) == at) {
        Set<String> component = new TreeSet<>();
        String member;
        do {
          member = stack.pop();
          onStack.remove(member);
          component.add(member);
        } while (!member.equals(method));
        if (component.size() > 1 || edges.getOrDefault(method, List.of()).contains(method)) {
          cycles.add(component);
        }
      }
    }
  }
}
