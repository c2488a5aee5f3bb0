package org.selectiverenderer.scriptengine.build;

import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.selectiverenderer.scriptengine.LanguageExtensions;

/** Lets Rhino's parser call {@link LanguageExtensions}. */
final class LanguageVisitor extends MethodVisitor {
  private static final String RHINO = "org/mozilla/javascript/";
  private static final String PARSER = RHINO + "Parser";
  private static final String AST_NODE = RHINO + "ast/AstNode";
  private static final String EXTENSIONS = RhinoTransformer.internal(LanguageExtensions.class);

  /** Rhino's token of three points. */
  private static final int DOTDOTDOT = 186;

  private final boolean tokens;
  private final boolean arguments;
  private final boolean trees;

  private LanguageVisitor(MethodVisitor next, boolean tokens, boolean arguments, boolean trees) {
    super(Opcodes.ASM9, next);
    this.tokens = tokens;
    this.arguments = arguments;
    this.trees = trees;
  }

  /** Returns a visitor of a method: one that changes it, or the next. */
  static MethodVisitor of(String owner, String method, MethodVisitor next) {
    boolean tokens = owner.equals(PARSER) && method.equals("peekToken");
    boolean arguments = owner.equals(PARSER) && method.equals("argumentList");
    boolean trees = owner.equals(RHINO + "IRFactory") && method.equals("transform");
    return tokens || arguments || trees
        ? new LanguageVisitor(next, tokens, arguments, trees)
        : next;
  }

  @Override
  public void visitCode() {
    super.visitCode();
    if (trees) { // transform(AstNode): the node is the first argument.
      super.visitVarInsn(Opcodes.ALOAD, 1);
      extension("withoutSpread", "(L" + AST_NODE + ";)L" + AST_NODE + ";");
      super.visitVarInsn(Opcodes.ASTORE, 1);
    }
  }

  @Override
  public void visitMethodInsn(
      int opcode, String type, String name, String descriptor, boolean ofInterface) {
    boolean argument = arguments && type.equals(PARSER) && name.equals("assignExpr");
    if (argument) { // On the stack: the parser. Then: whether there were points, the parser.
      super.visitInsn(Opcodes.DUP);
      super.visitIntInsn(Opcodes.SIPUSH, DOTDOTDOT);
      super.visitInsn(Opcodes.ICONST_1);
      super.visitMethodInsn(Opcodes.INVOKEVIRTUAL, PARSER, "matchToken", "(IZ)Z", false);
      super.visitInsn(Opcodes.SWAP);
    }
    super.visitMethodInsn(opcode, type, name, descriptor, ofInterface);
    if (argument) {
      extension("argument", "(ZL" + AST_NODE + ";)L" + AST_NODE + ";");
    }
    if (tokens && name.equals("getToken")) {
      innermost("currentScope", "ast/Scope");
      innermost("currentScriptOrFn", "ast/ScriptNode");
      extension("token", "(ILjava/lang/Object;Ljava/lang/Object;)I");
    }
  }

  private void innermost(String field, String type) {
    super.visitVarInsn(Opcodes.ALOAD, 0);
    super.visitFieldInsn(Opcodes.GETFIELD, PARSER, field, "L" + RHINO + type + ";");
  }

  private void extension(String name, String descriptor) {
    super.visitMethodInsn(Opcodes.INVOKESTATIC, EXTENSIONS, name, descriptor, false);
  }
}
