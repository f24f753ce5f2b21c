/* The file EYERAY_FONT, byte for byte, between two symbols. */
    .section .rodata
    .global eyeray_font_begin
    .global eyeray_font_end
    .balign 16
eyeray_font_begin:
    .incbin EYERAY_FONT
eyeray_font_end:

    .section .note.GNU-stack,"",%progbits
