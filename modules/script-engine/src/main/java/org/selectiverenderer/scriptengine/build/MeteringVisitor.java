package org.selectiverenderer.scriptengine.build;

import java.util.HashSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.selectiverenderer.scriptengine.ScriptMeter;
import org.selectiverenderer.scriptengine.build.RhinoTransformer.Replacements;

/** Inserts the meter's calls into a class of Rhino. */
final class MeteringVisitor extends ClassVisitor {
  /** The key of the message about BigInt among Rhino's messages. */
  static final String NO_BIG_INTEGERS = "msg.no.big.integers";

  private static final String METER = RhinoTransformer.internal(ScriptMeter.class);
  private static final String RHINO = "org/mozilla/javascript/";
  private static final String BIG_INTEGER = "java/math/BigInteger";
  private static final String MADE_OF = "$rhino";

  private final Replacements replacements;
  private final Set<String> entries;
  private String owner = "";

  /**
   * @param entries the methods whose entry is metered
   */
  MeteringVisitor(ClassVisitor next, Replacements replacements, Set<String> entries) {
    super(Opcodes.ASM9, next);
    this.replacements = replacements;
    this.entries = entries;
  }

  @Override
  public void visit(
      int version,
      int access,
      String name,
      @Nullable String signature,
      String superName,
      String[] interfaces) {
    owner = name;
    String[] all = interfaces;
    if (name.equals(RHINO + "Context")) {
      all = java.util.Arrays.copyOf(interfaces, interfaces.length + 1);
      all[interfaces.length] = "org/selectiverenderer/scriptengine/Metered";
    }
    super.visit(version, access, name, signature, superName, all);
  }

  @Override
  public @Nullable MethodVisitor visitMethod(
      int access,
      String name,
      String descriptor,
      @Nullable String signature,
      String @Nullable [] exceptions) {
    boolean interpreter = owner.startsWith(RHINO + "Interpreter");
    String made = name;
    if (interpreter && name.equals("interpretLoop")) {
      made = name + MADE_OF;
      wrap(access, name, made, descriptor);
    }
    MethodVisitor next = super.visitMethod(access, made, descriptor, signature, exceptions);
    if (owner.equals(RHINO + "Context") && name.equals("getCurrentContext")) {
      return new WithoutContext(next);
    }
    if (name.equals("$deserializeLambda$")) {
      return next;
    }
    // The interpreter counts the instructions of scripts itself.
    boolean counted = interpreter && (name.equals("interpretFunction") || name.equals("execute"));
    boolean entry = entries.contains(owner + "." + name + descriptor);
    return new Metering(LanguageVisitor.of(owner, name, next), entry, !counted);
  }

  /**
   * Writes a method that calls another within {@code beginNested} and {@code endNested} of the
   * meter.
   */
  private void wrap(int access, String name, String of, String descriptor) {
    MethodVisitor out = super.visitMethod(access, name, descriptor, null, null);
    Type[] arguments = Type.getArgumentTypes(descriptor);
    Object[] locals = new Object[arguments.length];
    Label from = new Label();
    Label to = new Label();
    Label failed = new Label();
    out.visitCode();
    out.visitTryCatchBlock(from, to, failed, null);
    meter(out, "beginNested", "()V");
    out.visitLabel(from);
    for (int i = 0; i < arguments.length; i++) {
      locals[i] = arguments[i].getInternalName();
      out.visitVarInsn(Opcodes.ALOAD, i); // All are references.
    }
    out.visitMethodInsn(Opcodes.INVOKESTATIC, owner, of, descriptor, false);
    out.visitLabel(to);
    meter(out, "endNested", "()V");
    out.visitInsn(Opcodes.ARETURN);
    out.visitLabel(failed);
    out.visitFrame(Opcodes.F_FULL, locals.length, locals, 1, new Object[] {"java/lang/Throwable"});
    meter(out, "endNested", "()V");
    out.visitInsn(Opcodes.ATHROW);
    out.visitMaxs(0, 0);
    out.visitEnd();
  }

  private static void meter(MethodVisitor out, String name, String descriptor) {
    out.visitMethodInsn(Opcodes.INVOKESTATIC, METER, name, descriptor, false);
  }

  /** Lets Context say that none is current while it is being initialised, which is metered, too. */
  private static final class WithoutContext extends MethodVisitor {
    WithoutContext(MethodVisitor next) {
      super(Opcodes.ASM9, next);
    }

    @Override
    public void visitCode() {
      super.visitCode();
      Label initialised = new Label();
      visitFieldInsn(
          Opcodes.GETSTATIC, RHINO + "Context", "currentContext", "Ljava/lang/ThreadLocal;");
      visitJumpInsn(Opcodes.IFNONNULL, initialised);
      visitInsn(Opcodes.ACONST_NULL);
      visitInsn(Opcodes.ARETURN);
      visitLabel(initialised);
      visitFrame(Opcodes.F_SAME, 0, null, 0, null);
    }
  }

  private final class Metering extends MethodVisitor {
    private final boolean entry;
    private final boolean loops;
    private final Set<Label> passed = new HashSet<>();

    Metering(MethodVisitor next, boolean entry, boolean loops) {
      super(Opcodes.ASM9, next);
      this.entry = entry;
      this.loops = loops;
    }

    @Override
    public void visitCode() {
      super.visitCode();
      if (entry) {
        meter(mv, "tick", "()V");
      }
    }

    @Override
    public void visitLabel(Label label) {
      passed.add(label);
      super.visitLabel(label);
    }

    /** A jump back closes a loop. */
    private void jump(Label... targets) {
      for (Label target : targets) {
        if (loops && passed.contains(target)) {
          meter(mv, "tick", "()V");
          return;
        }
      }
    }

    @Override
    public void visitJumpInsn(int opcode, Label label) {
      jump(label);
      super.visitJumpInsn(opcode, label);
    }

    @Override
    public void visitTableSwitchInsn(int min, int max, Label other, Label... labels) {
      jump(labels);
      jump(other);
      super.visitTableSwitchInsn(min, max, other, labels);
    }

    @Override
    public void visitLookupSwitchInsn(Label other, int[] keys, Label[] labels) {
      jump(labels);
      jump(other);
      super.visitLookupSwitchInsn(other, keys, labels);
    }

    @Override
    public void visitIntInsn(int opcode, int operand) {
      if (opcode == Opcodes.NEWARRAY) {
        allocated(
            switch (operand) {
              case Opcodes.T_LONG, Opcodes.T_DOUBLE -> 8;
              case Opcodes.T_INT, Opcodes.T_FLOAT -> 4;
              case Opcodes.T_CHAR, Opcodes.T_SHORT -> 2;
              default -> 1;
            });
      }
      super.visitIntInsn(opcode, operand);
    }

    private void allocated(int bytesEach) {
      super.visitInsn(Opcodes.DUP);
      super.visitIntInsn(Opcodes.BIPUSH, bytesEach);
      meter(mv, "allocate", "(II)V");
    }

    @Override
    public void visitTypeInsn(int opcode, String type) {
      if (opcode == Opcodes.ANEWARRAY) {
        allocated(8);
      }
      super.visitTypeInsn(opcode, type);
    }

    @Override
    public void visitMethodInsn(
        int opcode, String type, String name, String descriptor, boolean ofInterface) {
      if (type.equals(BIG_INTEGER)) {
        bigInteger(name, descriptor);
      }
      String key = type + "." + name + descriptor;
      String @Nullable [] by =
          switch (opcode) {
            case Opcodes.INVOKESTATIC -> replacements.statics().get(key);
            case Opcodes.INVOKEVIRTUAL, Opcodes.INVOKEINTERFACE -> replacements.instance().get(key);
            default -> null;
          };
      if (by != null) {
        super.visitMethodInsn(Opcodes.INVOKESTATIC, by[0], by[1], by[2], false);
        return;
      }
      if (owner.equals(RHINO + "Kit") && name.equals("printStackTrace")) {
        super.visitInsn(Opcodes.POP2); // A script's text could print it to the terminal.
        return;
      }
      if (name.equals("<init>")) {
        made(type, descriptor);
      }
      super.visitMethodInsn(opcode, type, name, descriptor, ofInterface);
    }

    /** Objects that take memory in proportion to their last argument. */
    private void made(String type, String descriptor) {
      boolean text = type.equals("java/lang/String") || type.startsWith("java/lang/StringBu");
      boolean collection = type.startsWith("java/util/");
      if (!text && !collection) {
        return;
      }
      if (descriptor.endsWith("I)V")) {
        super.visitInsn(Opcodes.DUP);
        meter(mv, text ? "allocateCharacters" : "allocateReferences", "(I)V");
      } else if (descriptor.equals("([C)V")
          || descriptor.equals("(Ljava/lang/String;)V")
          || descriptor.equals("(Ljava/lang/CharSequence;)V")
          || descriptor.equals("(Ljava/util/Collection;)V")
          || descriptor.equals("(Ljava/util/Map;)V")) {
        super.visitInsn(Opcodes.DUP);
        meter(mv, "copy", "(Ljava/lang/Object;)V");
      }
    }

    /**
     * No integer of any length becomes a script's value: the scanner reports the literal as a
     * syntax error and goes on with 0, and operations fail. How numbers are written is left alone.
     */
    private void bigInteger(String name, String descriptor) {
      if (owner.equals(RHINO + "TokenStream")) {
        if (name.equals("<init>")) {
          super.visitInsn(Opcodes.POP2);
          super.visitVarInsn(Opcodes.ALOAD, 0);
          super.visitFieldInsn(Opcodes.GETFIELD, owner, "parser", "L" + RHINO + "Parser;");
          super.visitLdcInsn(NO_BIG_INTEGERS);
          super.visitMethodInsn(
              Opcodes.INVOKEVIRTUAL, RHINO + "Parser", "addError", "(Ljava/lang/String;)V", false);
          super.visitLdcInsn("0");
          super.visitIntInsn(Opcodes.BIPUSH, 10);
        }
        return;
      }
      boolean ofScripts =
          owner.equals(RHINO + "ScriptRuntime")
              || owner.equals(RHINO + "NativeBigInt")
              || owner.startsWith(RHINO + "Interpreter")
              || owner.startsWith(RHINO + "typedarrays/");
      if (ofScripts && (name.equals("<init>") || descriptor.endsWith(")L" + BIG_INTEGER + ";"))) {
        meter(mv, "refuseBigInteger", "()V");
      }
    }
  }
}
