package org.selectiverenderer.lsl;

import java.io.IOException;
import org.lwjgl.system.APIUtil;
import org.lwjgl.system.MemoryStack;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.SharedLibrary;
import org.lwjgl.system.libffi.FFICIF;
import org.lwjgl.system.libffi.FFIType;
import org.lwjgl.system.libffi.LibFFI;

/** A C function of a library, called through libffi. Thread-safe. */
final class NativeFunction {
  /** The type of a parameter or a result, of at most eight bytes. */
  enum Type {
    VOID(LibFFI.ffi_type_void),
    INT(LibFFI.ffi_type_sint32),
    DOUBLE(LibFFI.ffi_type_double),
    POINTER(LibFFI.ffi_type_pointer);

    private final FFIType ffi;

    Type(FFIType ffi) {
      this.ffi = ffi;
    }
  }

  private static final int SLOT = 8;

  private final long address;
  private final Type result;
  private final FFICIF cif;

  private NativeFunction(long address, Type result, Type... parameters) {
    this.address = address;
    this.result = result;
    FFIType[] types = new FFIType[parameters.length];
    for (int i = 0; i < types.length; i++) {
      types[i] = parameters[i].ffi;
    }
    cif = APIUtil.apiCreateCIF(result.ffi, types);
  }

  /**
   * Looks up a function.
   *
   * @throws IOException if the library has no such function
   */
  static NativeFunction of(SharedLibrary library, String name, Type result, Type... parameters)
      throws IOException {
    long address = library.getFunctionAddress(name);
    if (address == MemoryUtil.NULL) {
      throw new IOException(
          library.getName() + ": is not a liblsl of version 1.13 or newer: it has no " + name);
    }
    return new NativeFunction(address, result, parameters);
  }

  /**
   * Calls the function.
   *
   * @param arguments one for each parameter: Integer, Double, or Long for a pointer
   * @return the bits of the result; 0 for a void function
   */
  private long bits(Number... arguments) {
    try (MemoryStack stack = MemoryStack.stackPush()) {
      long values = stack.nmalloc(SLOT, SLOT * Math.max(1, arguments.length));
      long pointers = stack.nmalloc(SLOT, SLOT * Math.max(1, arguments.length));
      for (int i = 0; i < arguments.length; i++) {
        long at = values + (long) i * SLOT;
        if (arguments[i] instanceof Double number) {
          MemoryUtil.memPutDouble(at, number);
        } else if (arguments[i] instanceof Integer number) {
          MemoryUtil.memPutInt(at, number);
        } else {
          MemoryUtil.memPutLong(at, arguments[i].longValue());
        }
        MemoryUtil.memPutAddress(pointers + (long) i * SLOT, at);
      }
      long returned = stack.ncalloc(SLOT, 1, SLOT);
      LibFFI.nffi_call(cif.address(), address, returned, pointers);
      return result == Type.VOID ? 0 : MemoryUtil.memGetLong(returned);
    }
  }

  /** Calls a function that returns void or a pointer. */
  long call(Number... arguments) {
    return bits(arguments);
  }

  /** Calls a function that returns an int. */
  int callInt(Number... arguments) {
    return (int) bits(arguments);
  }

  /** Calls a function that returns a double. */
  double callDouble(Number... arguments) {
    return Double.longBitsToDouble(bits(arguments));
  }
}
