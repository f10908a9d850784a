package org.cleft;

/** Types of voxels in buffers and raw files. */
public enum VoxelType {
    // <constants> made by tools/generate.py from include/cleft/cleft.h
    /** Unsigned whole numbers of 8 bits. */
    UINT8(CleftNative.CLEFT_TYPE_UINT8),
    /** Unsigned whole numbers of 16 bits. */
    UINT16(CleftNative.CLEFT_TYPE_UINT16),
    /** Signed whole numbers of 16 bits. */
    INT16(CleftNative.CLEFT_TYPE_INT16),
    /** Unsigned whole numbers of 32 bits. */
    UINT32(CleftNative.CLEFT_TYPE_UINT32),
    /** Signed whole numbers of 32 bits. */
    INT32(CleftNative.CLEFT_TYPE_INT32),
    /** Real numbers, single precision. */
    FLOAT32(CleftNative.CLEFT_TYPE_FLOAT32),
    /** Real numbers, double precision. */
    FLOAT64(CleftNative.CLEFT_TYPE_FLOAT64);
    // </constants>

    final int number;
    final int bytes;
    final boolean isWhole;

    VoxelType(int number) {
        this.number = number;
        bytes = Integer.parseInt(name().replaceAll("\\D", "")) / Byte.SIZE;
        isWhole = number != CleftNative.CLEFT_TYPE_FLOAT32 && number != CleftNative.CLEFT_TYPE_FLOAT64;
    }
}
